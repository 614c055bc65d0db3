// Scenarios with an external team on one side.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/marked_processes.h"
#include "tests/support/port_lock.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class ExternalScenario : public testing::Test {
 protected:
  void script(const std::string& name, const std::string& text) {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "#!/bin/sh\n" << export_mark(mark_) << text << "\n";
    ::chmod(file.c_str(), 0755);
  }

  /// A team folder whose start.sh starts players that turn by 10 degrees per cycle, and returns.
  void team(const std::string& flags = "", int players = 11) {
    script("guests/start.sh",
           "while [ $# -gt 0 ]; do case $1 in -p) port=$2;; -t) name=$2;; esac; shift; done\n"
           "for i in $(seq " +
               std::to_string(players) + "); do\n  goalie=; [ $i = 1 ] && goalie='--goalie 1'\n  " +
               player() + " --port $port --name $name $goalie " + flags + " &\n  sleep 0.02\ndone");
  }
  std::string player() const { return copy_built("cls_fake_player", folder_.path() / "guests"); }

  /// A left striker shoots at the goal behind player 5 of the external team.
  CommandResult play(const std::string& expect, const std::vector<std::string>& more = {},
                     const std::string& right = "team:guests") {
    const std::string file = folder_.path() / "guests.json";
    std::ofstream(file) << R"({"noise": false, "mode": "play_on", "steps": 20,
      "ball": {"at": [40.6, 3]},
      "left": {"playmaker": {"rules": [{"when": {"state": {"self.is_kickable": true}},
                                        "reply": [{"kick": {"power": 100}}]}]},
               "players": {"9": {"at": [40, 3]}}},
      "right": {"playmaker": ")"
                        << right << R"(", "players": {"1": {"at": [50, -3]},
                                              "5": {"at": [30, 10], "body": 90}}},
      "under_test": "right", "expect": [)"
                        << expect << "]}";

    CommandResult result =
        run(joined({cls_binary(), "test", file, "--dir", folder_.path() / "kept"}, more),
            {std::string(kMarkVariable) + "=" + mark_});
    EXPECT_TRUE(all_marked_gone(mark_));

    return result;
  }

  std::string path(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
  const std::string mark_ = new_mark();
};

// The server sets up the situation: external players start at the given positions and act.
TEST_F(ExternalScenario, PlacesExternalPlayers) {
  team();
  EXPECT_THAT(play(R"(
    {"player": "right 5", "is": {"near": [30, 10], "within": 0.1}, "always": true},
    {"player": "right 5", "is": {"body": {"between": [99, 101]}}, "at": 2},
    {"player": "right 4", "is": {"on_pitch": false}, "always": true},
    {"first_touch": "left 9"}, {"score": [1, 0]}, {"referee": "goal_l_1", "count": 1})"),
              Exits(0));
}

TEST_F(ExternalScenario, AcceptsAgentsWithFixedPorts) {
  const PortLock lock;
  script("guests/start",
         "[ $3 = 1 ] && more='--goalie 1'\nexec " + player() + " --name Guests $more");
  const CommandResult result =
      play(R"({"score": [1, 0]}, {"player": "right 5", "is": {"on_pitch": true}})");
  if (result.out.find("is taken by") != std::string::npos) GTEST_SKIP() << "port 6000 is taken";
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST_F(ExternalScenario, ReportsProgramOfCrashedPlayer) {
  const PortLock lock;
  script("guests/start",
         "[ $3 = 1 ] && more='--goalie 1'\n[ $3 = 5 ] && more='--exit-at-cycle 5'\n" +
             std::string("exec ") + player() + " --name Guests $more");
  const CommandResult played =
      play(R"({"score": [0, 0]}], "rpc_deadline_ms": 300, "until": [{"goals": 9})");
  if (played.out.find("is taken by") != std::string::npos) GTEST_SKIP() << "port 6000 is taken";
  EXPECT_EQ(played.exit_code, 1);
  EXPECT_THAT(played.out, HasSubstr("the process of right player 5 ended at cycle "));
  EXPECT_THAT(played.out, HasSubstr("last output line: lost my boots"));
}

TEST_F(ExternalScenario, TakesSideUnderTest) {
  team();
  EXPECT_THAT(play(R"({"score": [1, 0]},
                  {"player": "right 5", "is": {"body": {"between": [99, 101]}}, "at": 2})",
                   {"--against", "team:" + path("guests")}, "mock:hold"),
              Exits(0));
}

TEST_F(ExternalScenario, RejectsChecksThatNeedAPlaymaker) {
  team();
  EXPECT_THAT(play(R"({"actions": "dash", "side": "right"})"),
              Exits(65, HasSubstr("/expect/0: an external team has no Playmaker: ")));
  EXPECT_THAT(play(R"({"commands": "dash", "side": "right"})",
                   {"--against", "team:" + path("guests")}, "mock:hold"),
              Prints(0, HasSubstr("skip  guests: line ")));
}

// A player that exits after the request is missed once; the next request does not reach it.
TEST_F(ExternalScenario, EndsAsCrashedWhenPlayersDisconnect) {
  team("--exit-at-cycle 5");
  const std::string impatient = R"(], "rpc_deadline_ms": 300, "until": [{"goals": 9})";
  EXPECT_THAT(play(R"({"end": "crashed"})" + impatient), Exits(0));
  EXPECT_THAT(
      play(R"({"score": [0, 0]})" + impatient),
      Prints(1, testing::AllOf(HasSubstr("the run ended as crashed, not finished: right (team:"),
                               HasSubstr(" has left (at cycle "))));
}

TEST_F(ExternalScenario, EndsAsLateWithoutReplies) {
  team("--hang-at-cycle 5");
  const std::string expect =
      R"({"end": "late"}], "rpc_deadline_ms": 100, "max_missed": 2, "until": [{"goals": 9})";
  EXPECT_THAT(play(expect), Exits(0));
}

TEST_F(ExternalScenario, ReportsInvalidTeamFolder) {
  EXPECT_THAT(play(R"({"score": [0, 0]})"), Prints(1, HasSubstr("guests: no such folder")));
  script("guests/start.sh", "echo no formation found; exit 3");
  EXPECT_THAT(
      play(R"({"score": [0, 0]})"),
      Prints(1, HasSubstr("the process of right team ended before the match: exit code 3")));
}

}  // namespace
}  // namespace cls::tests
