// `cls dev`: plays scenarios again when files change, and reports what differs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

class DevCommand : public testing::Test {
 protected:
  DevCommand() {
    std::filesystem::create_directories(folder_.path() / "tests");
    write("tests/runs.json", R"({
      "about": "Player 8 runs forward.",
      "mode": "play_on",
      "left": {"playmaker": "mock:../team.json", "players": {"8": {"at": [0, 20]}}},
      "right": {"playmaker": "mock:hold", "players": {"2": {"at": [40, -30]}}},
      "under_test": "left",
      "steps": 10,
      "expect": [{"player": "left 8", "is": {"x": {">": 2}}, "at": "end"}]
    })");
    write_team(20);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
  }

  // Runs to x.
  void write_team(int x) const {
    write("team.json", R"({"rules": [{"reply": [{"body_go_to_point": {"target_point": {"x": )" +
                           std::to_string(x) +
                           R"(, "y": 20}, "distance_threshold": 0.5, "max_dash_power": 100}}]}]})");
  }

  std::vector<std::string> dev(const std::vector<std::string>& more = {}) const {
    const std::vector<std::string> words = joined({cls_binary(), "dev"}, more);
    return words;
  }

  TemporaryFolder folder_;
};

TEST_F(DevCommand, PlaysAgainAfterChange) {
  Command command(dev(), {}, folder_.path());
  ASSERT_TRUE(command.wait_for_output("watching .")) << command.out();
  EXPECT_THAT(command.out(), HasSubstr("ok    runs\n"));
  write_team(-20);
  ASSERT_TRUE(command.wait_for_output("decisions differ")) << command.out();
  const std::string out = command.out();
  EXPECT_THAT(out, HasSubstr("changed: team.json\nFAIL  runs (passed before)\n"));
  EXPECT_THAT(out, HasSubstr(", player 8: "));
  write_team(20);
  ASSERT_TRUE(command.wait_for_output("ok    runs (failed before)")) << command.out();
  command.send_signal(SIGINT);
  EXPECT_EQ(command.finish().exit_code, 130);
}

TEST_F(DevCommand, ReportsEachRoundAsJson) {
  Command command(dev({"tests/runs.json", "--json"}), {}, folder_.path());
  ASSERT_TRUE(command.wait_for_output("\n")) << command.out();
  const auto round = base::Json::parse(command.out());
  EXPECT_EQ(round["schema"], "cls.dev/1");
  EXPECT_EQ(round["scenarios"][0]["passed"], true);
  EXPECT_TRUE(round["scenarios"][0]["difference"].is_null());
  command.send_signal(SIGTERM);
  EXPECT_EQ(command.finish().exit_code, 143);
}

TEST_F(DevCommand, ReportsWhatKeepsProgramFromStarting) {
  Command command(
      dev({"tests/runs.json", "--against",
           "run:exec " + built("cls_fake_playmaker") + " --port {port} --exit-at-start 5"}),
      {}, folder_.path());
  ASSERT_TRUE(command.wait_for_output("watching .")) << command.out();
  EXPECT_THAT(command.out(), HasSubstr("cannot load the formation"));
  command.send_signal(SIGINT);
  command.finish();
}

// Nothing is new in what a program prints for each scenario.
TEST_F(DevCommand, PrintsTheSameOutputOfAProgramOnce) {
  Command command(
      dev({"tests/runs.json", "tests/runs.json", "--against",
           "run:exec " + built("cls_fake_playmaker") + " --port {port} --exit-at-start 5"}),
      {}, folder_.path());
  ASSERT_TRUE(command.wait_for_output("watching .")) << command.out();
  const std::string out = command.out();
  const std::string line = "        cannot load the formation\n";
  ASSERT_THAT(out, HasSubstr(line));
  EXPECT_EQ(out.find(line), out.rfind(line)) << out;
  EXPECT_THAT(out, HasSubstr("        the same output as above\n"));
  command.send_signal(SIGINT);
  command.finish();
}

// The error once, with the command that sends its State again, instead of the checks that fail
// for it.
TEST_F(DevCommand, ReportsErrorsOfDecisions) {
  Command command(dev(), {}, folder_.path());
  ASSERT_TRUE(command.wait_for_output("watching .")) << command.out();
  write("team.json", R"({"faults": {"error": 1, "message": "ValueError: no plan at decide.py:17",
                                    "only": {"unum": 8}}})");
  ASSERT_TRUE(command.wait_for_output("FAIL  runs (passed before)")) << command.out();
  ASSERT_TRUE(command.wait_for_output("cls test --replay")) << command.out();

  write_team(20);
  ASSERT_TRUE(command.wait_for_output("ok    runs (failed before)")) << command.out();

  const std::string out = command.out();
  const std::string error = "ValueError: no plan at decide.py:17";
  const std::size_t first = out.find(error);
  ASSERT_NE(first, std::string::npos) << out;
  EXPECT_EQ(out.find(error, first + 1), std::string::npos) << out;
  EXPECT_THAT(out, Not(HasSubstr("misses no decision")));
  command.send_signal(SIGINT);
  command.finish();
}

TEST_F(DevCommand, ContinuesAfterBrokenScenario) {
  Command command(dev(), {}, folder_.path());
  ASSERT_TRUE(command.wait_for_output("watching .")) << command.out();
  write("tests/runs.json", "{\n  \"steps\": -1}");
  ASSERT_TRUE(command.wait_for_output("runs.json:2")) << command.out();
  command.send_signal(SIGINT);
  EXPECT_EQ(command.finish().exit_code, 130);
}

// Its own output is not a change of the team.
TEST_F(DevCommand, IgnoresItsOutputInTheWatchedFolder) {
  Command command({"/bin/sh", "-c", "exec '" + cls_binary().string() + "' dev >out.txt"}, {},
                  folder_.path());
  const auto rounds = [this] {
    const std::string out = read_file(folder_.path() / "out.txt");
    std::size_t count = 0;
    for (std::size_t at = out.find("watching ."); at != std::string::npos;
         at = out.find("watching .", at + 1)) {
      ++count;
    }
    return count;
  };
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!std::filesystem::exists(folder_.path() / "out.txt") ||
         (rounds() == 0 && std::chrono::steady_clock::now() < limit)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }

  std::this_thread::sleep_for(std::chrono::seconds(2));
  EXPECT_EQ(rounds(), 1u);

  command.send_signal(SIGINT);
  command.finish();
}

TEST_F(DevCommand, RefusesUnknownScenario) {
  Command command(dev({"test/runs.json"}), {}, folder_.path());
  const CommandResult result = command.finish();
  EXPECT_EQ(result.exit_code, 66);
  EXPECT_THAT(result.err, HasSubstr("unknown scenario 'test/runs.json'"));
  EXPECT_THAT(result.out, Not(HasSubstr("watching")));
}

TEST_F(DevCommand, NeedsScenarios) {
  const TemporaryFolder empty;
  Command command(dev(), {}, empty.path());
  EXPECT_THAT(command.finish(), Exits(66, HasSubstr("no folder tests/ here")));
}

}  // namespace
}  // namespace cls::tests
