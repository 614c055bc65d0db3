// Matches of external teams with each kind of fault.
#include "tests/cli/network_match.h"

#include <gmock/gmock.h>

#include "tests/support/host_namespaces.h"
#include "tests/support/port_lock.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;
using json = base::Json;
using TeamFault = NetworkMatch;

namespace fs = std::filesystem;

// The script ends after a process that it has left to others.
TEST_F(TeamFault, NamesTheLimitThatEndedAProcessOfTheTeam) {
  script("team/start.sh",
         "(sh -c 'echo $$ > pid; while :; do :; done' &)\n"
         "while [ ! -s pid ]; do sleep 0.1; done\n"
         "while kill -0 $(cat pid); do sleep 0.1; done\nexit 3");
  play("team:" + (folder_.path() / "team").string(), "embedded", {"--max-cpu", "1"});
  expect_end("refused", 69,
             "the process of right team ended before the match: exit code 3; a process of right "
             "team had used the 1 s of CPU time that --max-cpu allows: raise or omit the limit");
}

TEST_F(TeamFault, ReportsExitAtStart) {
  play(team("--exit-at-start 2"), server(""));
  // The script succeeds, but its players are gone.
  expect_end("refused", 69, "the process of right team ended before the match");
  expect_failed("right team", "cannot read formation.conf");
  EXPECT_LT(took_, 10s);
}

TEST_F(TeamFault, ReportsTeamThatNeverConnects) {
  play(team("--never-join 1"), server(""), {"--start-timeout", "2"});
  expect_end("refused", 69, "0 of 11 players of the right team have joined within the start limit");
}

TEST_F(TeamFault, ReportsDifferentTeamName) {
  play(team("--name Others"), server(""), {"--right-name", "Guests"});
  expect_end("refused", 69, "the team plays under the name Others instead of Guests");
}

TEST_F(TeamFault, ReportsTeamNameOfOpponent) {
  play(team("--name hold"), server(""), {"--right-name", "Guests", "--start-timeout", "2"});
  expect_end("refused", 69, "; or it plays under the name hold too");
}

TEST_F(TeamFault, ReportsCrashOfAllPlayers) {
  play(team("--exit-at-cycle 10"), server(""));
  expect_end("crashed", 1, "the process of right team ended at cycle ");
  expect_failed("right team", "lost my boots");
}

TEST_F(TeamFault, ReportsHangDuringMatch) {
  play(team("--hang-at-cycle 10"), server(""), {"--stall-after", "1"});
  expect_end("stalled", 1, "no new cycle for 1 s");
}

// On a busy host others may miss cycles, too.
TEST_F(TeamFault, WarnsOfCyclesThatATeamMissed) {
  const std::string cls_server =
      script("server", "exec " + cls_binary().string() + " server \"$@\"");
  for (const std::string& server : {std::string("embedded"), cls_server}) {
    SCOPED_TRACE(server);
    play(team("--miss-cycle 10"), server, {"--cycles", "25", "--rpc-deadline", "500"});
    expect_finished();
    EXPECT_GE(result_["server"]["missed_cycles"], 1);
    EXPECT_THAT(played_.err, HasSubstr("the soccer server did not wait for all clients in "));
  }
}

// The cls agents have replied to every cycle, so the server gave up waiting for the others.
TEST_F(TeamFault, BlamesTheTeamThatTheServerGaveUp) {
  play(team(""), server("--until-cycle 20 --give-up 1 --code 1"), {"--right-name", "Guests"});
  expect_end("late", 1, "clients stopped responding: those of Guests (team:");
  EXPECT_THAT(played_.err, HasSubstr("a team without synchronous mode needs --mode realtime"));
  EXPECT_EQ(result_["fault"], "right");
}

// The log of a match that ends at its cycle limit is whole, though no agent of cls confirms it.
TEST_F(TeamFault, PlaysWithoutClsAgentsToTheCycleLimit) {
  left_ = team("");
  play(left_, "embedded", {"--cycles", "30", "--left-name", "Reds", "--right-name", "Blues"});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 30);
}

// The team of start.sh gets the coach's port and starts no coach.
TEST_F(TeamFault, WarnsOfCoachThatNeverJoined) {
  const std::vector<std::string> options = {"--cycles", "320", "--right-name", "Guests"};
  play(team(""), "embedded", options);
  expect_finished();
  EXPECT_THAT(played_.err, HasSubstr("no coach has joined at port "));
  EXPECT_THAT(result_["warnings"].dump(), HasSubstr("no coach has joined at port "));
}

TEST_F(TeamFault, ExpectsNoCoachOfTeamWithoutOne) {
  play(team(""), "embedded", {"--cycles", "320", "--right-name", "Guests", "--no-coach"});
  expect_finished();
  EXPECT_THAT(played_.err, Not(HasSubstr("coach")));
}

TEST_F(TeamFault, NamesArgumentsOfStartThatOnlyPrintsItsHelp) {
  script("team/start.sh", "echo 'usage: start.sh -H HOST'");
  play("team:" + (folder_.path() / "team").string(), "embedded", {"--right-name", "Guests"});
  expect_end("refused", 69, "it was called with -h 127.0.0.1 -p ");
}

TEST_F(TeamFault, KillsTeamThatIgnoresSigterm) {
  play(team("--ignore-term 1 --grandchild 1"), server(""), {"--cycles", "10"});
  expect_finished();
}

TEST_F(TeamFault, ReportsMissingFolder) {
  play("team:/no/such/team", server(""));
  expect_end("refused", 69, "team folder /no/such/team: no such folder");
}

TEST_F(TeamFault, ReportsMissingStartScript) {
  script("team/play", "exit 0");
  play("team:" + (folder_.path() / "team").string(), server(""));
  expect_end("refused", 69, ": neither start nor start.sh in it");
}

TEST_F(TeamFault, ReportsIncompleteTeam) {
  play(team("", 10), server(""), {"--start-timeout", "2"});
  expect_end("refused", 69,
             "10 of 11 players of the right team have joined within the start limit");
}

// On the embedded server nobody else can have its places.
TEST_F(TeamFault, BlamesATeamThatDoesNotBringElevenPlayers) {
  play(team("", 10), "embedded", {"--start-timeout", "3"});
  expect_end("refused", 69, "10 of 11 players of the right team have joined within");
  EXPECT_EQ(result_["fault"], "right");

  play(team("--never-join 1"), "embedded", {"--start-timeout", "2"});
  expect_end("refused", 69, "0 of 11 players of the right team have joined within");
  EXPECT_EQ(result_["fault"], "right");

  fs::remove_all(folder_.path() / "team");
  play(team_of_single_agents("--players 2"), "embedded");
  expect_end("refused", 69, "right player 7 brought players 1, 2, 3, 4, 5, 6, 7, 8 onto the pitch");
  EXPECT_EQ(result_["fault"], "right");
}

TEST_F(TeamFault, BlamesATeamThatPlaysUnderAnotherName) {
  play(team("--name Others"), "embedded", {"--right-name", "Guests"});
  expect_end("refused", 69, "the team plays under the name Others instead of Guests");
  EXPECT_EQ(result_["fault"], "right");
}

// A relay keeps its places on a server that takes any client.
TEST_F(TeamFault, BlamesATeamBehindARelayForMissingPlayers) {
  if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
  play(team("", 10), server(""), {"--start-timeout", "3"});
  expect_end("refused", 69, "10 of 11 players of the right team have joined within");
  EXPECT_EQ(result_["fault"], "right");
}

// It would need another name on such a server.
TEST_F(TeamFault, BlamesNobodyBehindARelayForTheNameOfTheOther) {
  if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
  play(team("--name hold"), server(""), {"--start-timeout", "3"});
  EXPECT_EQ(result_["end_reason"], "refused") << played_.err;
  EXPECT_TRUE(result_["fault"].is_null()) << played_.err;
}

// Otherwise its places may be those of others.
TEST_F(TeamFault, BlamesNobodyForMissingPlayersElsewhere) {
  play(team("", 10), server(""), {"--start-timeout", "2", "--sandbox=files"});
  expect_end("refused", 69, "10 of 11 players of the right team have joined within");
  EXPECT_TRUE(result_["fault"].is_null());
}

TEST_F(TeamFault, AcceptsOwnNameOfTeam) {
  play(team("--name Others"), server(""), {"--cycles", "10"});
  expect_finished();
  EXPECT_EQ(result_["right"]["name"], "Others");
  EXPECT_THAT(played_.err, HasSubstr("plays under the name Others instead of team"));
}

TEST_F(TeamFault, AcceptsDisconnectAtTimeOver) {
  play(team("--exit-at-cycle 60 --code 0"), server(""), {"--half-time", "3"});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 60);
}

TEST_F(TeamFault, ReportsCrashOfOneAgent) {
  const PortLock lock;
  play(team_of_single_agents("--exit-at-cycle 10"), server(""));
  if (played_.exit_code == 75) GTEST_SKIP() << played_.err;
  expect_end("crashed", 1, "the process of right player 7 ended at cycle ");
  expect_failed("right player 7", "lost my boots");
  EXPECT_EQ(result_["failure"]["exit"], "exit code 4");
}

TEST_F(TeamFault, ReportsAgentThatNeverConnects) {
  const PortLock lock;
  play(team_of_single_agents("--never-join 1"), server(""), {"--start-timeout", "2"});
  if (played_.exit_code == 75) GTEST_SKIP() << played_.err;
  expect_end("refused", 69, "right player 7 has not joined within the start limit");
  EXPECT_EQ(result_["failure"]["process"], "right player 7");
}

TEST_F(TeamFault, ReportsAgentThatConnectsTwoPlayers) {
  const PortLock lock;
  play(team_of_single_agents("--players 2"), server(""));
  if (played_.exit_code == 75) GTEST_SKIP() << played_.err;
  expect_end("refused", 69, "right player 7 brought players 1, 2, 3, 4, 5, 6, 7, 8 onto the pitch");
}

TEST_F(TeamFault, AcceptsOwnNameWithOwnNamesOption) {
  const PortLock lock;
  play(team_of_single_agents(""), server(""), {"--right-name", "Visitors"});
  if (played_.exit_code == 75) GTEST_SKIP() << played_.err;
  expect_end("refused", 69, "the team plays under the name Guests instead of Visitors");
}

TEST_F(TeamFault, TerminatesHangingKillScript) {
  script("team/kill", "trap '' TERM\nwhile true; do sleep 1; done");
  play(team("--ignore-term 1"), server(""), {"--cycles", "10"});
  expect_finished();
  EXPECT_EQ(result_["processes"].back()["exit"], "ended by cls (killed by SIGKILL)");
}

TEST_F(TeamFault, PrintsFiveAndStoresFiftyLastOutputLines) {
  script("team/start.sh", "for i in $(seq 100); do echo line $i; done; exit 1");
  play("team:" + (folder_.path() / "team").string(), server(""));
  expect_end("refused", 69, "the process of right team ended before the match: exit code 1");
  const json& output = result_["failure"]["output"];
  ASSERT_EQ(output.size(), 50U);
  EXPECT_EQ(output.front(), "line 51");
  EXPECT_EQ(output.back(), "line 100");
  EXPECT_THAT(played_.err, Not(HasSubstr("line 95\n")));
  EXPECT_THAT(played_.err, HasSubstr("  right team: line 96\n"));
  EXPECT_THAT(played_.err, HasSubstr("  right team: line 100\n"));
}

TEST_F(TeamFault, ContinuesDespiteFloodOfOutput) {
  play(team("--flood 1"), server(""), {"--cycles", "10"});
  expect_finished();
  EXPECT_LT(std::filesystem::file_size(match_folder() + "/right-team.log"), 20'000U);
}

TEST_F(TeamFault, ReportsCrashOfPlaymakerOverUdp) {
  play("run:exec " + built("cls_fake_playmaker") + " --port {port} --exit-at-cycle 10", server(""));
  expect_end("crashed", 1, "its process ended at cycle ");
  expect_failed("right Playmaker", "out of ideas");
}

TEST_F(TeamFault, RefusesPlaymakerThatNeverListensOverUdp) {
  play("run:exec " + built("cls_fake_playmaker") + " --port {port} --never-listen 1", server(""),
       {"--start-timeout", "1"});
  expect_end("refused", 69, "it did not listen on port");
}

}  // namespace
}  // namespace cls::tests
