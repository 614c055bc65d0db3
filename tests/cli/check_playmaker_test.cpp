// End-to-end tests of `cls check playmaker`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/junit.h"
#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using testing::Not;

CommandResult check(std::vector<std::string> arguments) {
  // These tests do not measure latency: a loaded host must not fail them.
  return run(joined({cls_binary(), "check", "playmaker", "--latency-limit", "60000"}, arguments));
}

/// Results by step name.
std::map<std::string, std::string> results_of(const json& document) {
  std::map<std::string, std::string> results;
  for (const json& step : document["steps"]) {
    results[step["name"].get<std::string>()] = step["result"].get<std::string>();
  }
  return results;
}

std::string program_line(const std::string& arguments) {
  return "run:" + cls_binary().string() + " mock --port {port} " + arguments;
}

TEST(CheckPlaymaker, MockPassesEveryStep) {
  const CommandResult result = check({"mock", "--calls", "1000", "--json"});
  const json document = json::parse(result.out);
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_EQ(document["schema"], "cls.check/1");
  EXPECT_EQ(document["subject"], "mock");
  EXPECT_EQ(document["passed"], true);
  EXPECT_GE(document["steps"].size(), 60u);
  EXPECT_EQ(document["steps_failed"], 0);
  EXPECT_EQ(document["steps_skipped"], 1);  // an in-process mock has no port for garbage
  for (const json& step : document["steps"]) {
    EXPECT_FALSE(step["why"].get<std::string>().empty()) << step["name"];
  }
}

TEST(CheckPlaymaker, MeasuresMemoryOfRunSide) {
  if (CLS_SANITIZED)
    GTEST_SKIP() << "address sanitizer keeps freed memory, which looks like a leak";
  EXPECT_THAT(check({program_line(""), "--calls", "1000"}),
              Prints(0, testing::AllOf(HasSubstr(" MB after 1000"), HasSubstr("pass garbage "))));
}

// A heap that grows once, as those of garbage collectors do, is not a leak. It grows in the calls
// of this step, which follow about 4200 of others.
TEST(CheckPlaymaker, TellsALeakFromAHeapThatGrowsOnce) {
  if (CLS_SANITIZED) GTEST_SKIP() << "address sanitizer keeps freed memory";
  const auto memory_of = [](const std::string& fault) {
    const std::string side = "run:exec " + built("cls_fake_playmaker") + " --port {port} " + fault;
    return check({side, "--calls", "1000"}).out;
  };
  EXPECT_THAT(memory_of("--grow-at-call 4600"),
              testing::ContainsRegex("pass memory .* MB after 1000, .* MB after 1800\n"));
  EXPECT_THAT(memory_of("--leak-kb 50"),
              testing::ContainsRegex("FAIL memory .* MB after 1000, .* MB after 1800\n"));
}

TEST(CheckPlaymaker, FailsStepsWithUnimplementedRpcs) {
  // Unimplemented RPCs are not failures if the proxy works without them.
  const CommandResult result =
      check({program_line("--unimplemented GetBestPlannerAction,GetCoachActions,SendPlayerType"),
             "--calls", "100", "--json"});
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  const auto results = results_of(json::parse(result.out));
  EXPECT_EQ(results.at("planner"), "skip");
  EXPECT_EQ(results.at("coach_actions"), "skip");
  EXPECT_EQ(results.at("together_handshake"), "skip");
  EXPECT_EQ(results.at("together_actions"), "skip");
  EXPECT_EQ(results.at("both_teams_at_once"), "pass");
  EXPECT_EQ(results.at("all_parameters"), "fail");
  EXPECT_EQ(results.at("player_actions"), "pass");
  EXPECT_EQ(results.at("second_match"), "fail");
  EXPECT_EQ(results.at("bye"), "pass");
}

TEST(CheckPlaymaker, FailsWhenPlayersGetSameClientId) {
  const CommandResult result =
      check({program_line("--wrong-client-id"), "--calls", "100", "--json"});
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  const auto results = results_of(json::parse(result.out));
  EXPECT_EQ(results.at("register_team"), "fail");
  EXPECT_EQ(results.at("reach"), "pass");
}

TEST(CheckPlaymaker, SkipsRemainingStepsAfterProgramExit) {
  const CommandResult result = check(
      {program_line("--crash-at-cycle 5"), "--calls", "100", "--rpc-deadline", "500", "--json"});
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  const json document = json::parse(result.out);
  EXPECT_GT(document["steps_failed"], 0);
  EXPECT_EQ(document["steps"].back()["result"], "skip");
  EXPECT_THAT(document["steps"].back()["evidence"].get<std::string>(),
              HasSubstr("the program exited"));
}

TEST(CheckPlaymaker, FailsImmediatelyWhenProgramExitsAtStart) {
  // Waiting for the whole start timeout would exceed the limit of this test.
  const CommandResult result = check(
      {"run:sleep 1; echo no formation; exit 3; : {port}", "--start-timeout", "600", "--json"});
  EXPECT_EQ(result.exit_code, 69) << result.out << result.err;
  const json reach = json::parse(result.out)["steps"].front();
  EXPECT_NE(reach["result"], "pass");
  EXPECT_THAT(reach["evidence"].get<std::string>(),
              HasSubstr("the program exited (exit code 3); last output line: no formation"))
      << reach["evidence"];
}

TEST(CheckPlaymaker, ReportsFailuresByExitCode) {
  const CommandResult unreachable = check({"127.0.0.1:9", "--start-timeout", "0.3", "--json"});
  EXPECT_EQ(unreachable.exit_code, 69) << unreachable.out << unreachable.err;
  EXPECT_EQ(results_of(json::parse(unreachable.out)).at("bye"), "skip");
  // In text, one line about it, and no lines of skipped steps.
  const CommandResult text = check({"127.0.0.1:9", "--start-timeout", "0.3"});
  EXPECT_THAT(text.out, Not(HasSubstr("skip ")));
  EXPECT_THAT(text.out, HasSubstr("nothing listens at 127.0.0.1:9"));
  EXPECT_LT(std::ranges::count(text.out, '\n'), 8) << text.out;
  // A program that exits before the first step is unreachable too.
  EXPECT_EQ(check({"run:exit 3; : {port}", "--start-timeout", "0.5"}).exit_code, 69);
  EXPECT_EQ(check({"team:somewhere"}).exit_code, 2);
  EXPECT_EQ(check({"nonsense"}).exit_code, 2);
  EXPECT_EQ(check({"mock:nowhere.json"}).exit_code, 66);
  EXPECT_EQ(check({}).exit_code, 2);
}

TEST(CheckPlaymaker, WritesCiReports) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "junit.xml";
  const CommandResult result = check({program_line("--unimplemented SendPlayerType"), "--calls",
                                      "100", "--junit", file, "--github"});
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  const std::string xml = read_file(file);
  EXPECT_THAT(xml, HasSubstr("name=\"all_parameters\""));
  EXPECT_EQ(junit_errors(xml).value_or(""), "");
  EXPECT_THAT(result.err, HasSubstr("::error title=cls check playmaker run"));
  EXPECT_THAT(result.err, HasSubstr(" all_parameters::"));
  EXPECT_EQ(check({"mock", "--calls", "10", "--junit", "/no/such/folder/junit.xml"}).exit_code, 73);
}

}  // namespace
}  // namespace cls::tests
