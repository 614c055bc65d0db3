// Matches over UDP with external servers and teams, working and with each kind of fault.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/marked_processes.h"
#include "tests/support/port_lock.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace std::chrono_literals;
using cls::tests::built;
using cls::tests::Command;
using cls::tests::CommandResult;
using nlohmann::json;
using Arguments = std::vector<std::string>;

/// A match whose processes carry a mark in their environment, to find survivors.
class NetworkMatch : public testing::Test {
 protected:
  std::string script(const std::string& name, const std::string& text) {
    const std::filesystem::path file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "#!/bin/sh\n" << cls::tests::export_mark(mark_) << text << "\n";
    ::chmod(file.c_str(), 0755);
    return file;
  }

  /// A server program with these flags.
  std::string server(const std::string& flags) {
    return script("server", "exec " + built("cls_fake_server") + " " + flags + " \"$@\"");
  }

  /// The program of the team's agents.
  std::string player() const {
    return cls::tests::copy_built("cls_fake_player", folder_.path() / "team");
  }

  /// A team folder with a start.sh that starts up to 11 players and returns.
  std::string team(const std::string& flags, int players = 11) {
    script("team/start.sh",
           "while [ $# -gt 0 ]; do case $1 in -p) port=$2;; -t) name=$2;; esac; shift 2; done\n"
           "for i in $(seq " +
               std::to_string(players) +
               "); do\n"
               "  goalie=; [ $i = 1 ] && goalie='--goalie 1'\n" +
               player() + " --port $port --name $name $goalie " + flags + " &\n  sleep 0.02\ndone");
    return "team:" + (folder_.path() / "team").string();
  }

  /// A team folder whose `start` runs player 7 with `flags`; agent 12 only waits.
  std::string team_of_single_agents(const std::string& flags) {
    script("team/start",
           "[ $3 = 12 ] && exec sleep 1000\n[ $3 = 1 ] && more='--goalie 1'\n"
           "[ $3 = 7 ] && more='" +
               flags + "'\nexec " + player() + " --name Guests $more");
    return "team:" + (folder_.path() / "team").string();
  }

  Arguments arguments(const std::string& right, const std::string& server, const Arguments& more,
                      const Arguments& settings = {"--set", "server::kick_off_wait=3"}) const {
    Arguments argv = {
        cls::tests::cls_binary(), "match",   left_,      right, "--seed", "7", "--dir",
        match_folder(),           "--force", "--server", server};
    argv.insert(argv.end(), settings.begin(), settings.end());
    argv.insert(argv.end(), more.begin(), more.end());
    return argv;
  }
  std::string match_folder() const { return folder_.path() / "match"; }
  Arguments environment() const { return {std::string(cls::tests::kMarkVariable) + "=" + mark_}; }

  /// Plays; no process may survive the return of cls.
  void play(const std::string& right, const std::string& server, const Arguments& more = {},
            const Arguments& settings = {"--set", "server::kick_off_wait=3"}) {
    const auto begin = std::chrono::steady_clock::now();
    played_ = cls::tests::run(arguments(right, server, more, settings), environment());
    took_ = std::chrono::steady_clock::now() - begin;
    EXPECT_TRUE(cls::tests::marked_processes(mark_).empty());
    const std::string file = match_folder() + "/result.json";
    if (std::filesystem::exists(file)) result_ = json::parse(cls::tests::read_file(file));
  }

  void expect_finished() const {
    EXPECT_EQ(played_.exit_code, 0) << played_.err;
    EXPECT_EQ(result_.value("end_reason", ""), "finished");
  }

  void expect_end(const std::string& reason, int exit_code, const std::string& message) const {
    EXPECT_EQ(result_.value("end_reason", ""), reason) << played_.err;
    EXPECT_EQ(played_.exit_code, exit_code);
    EXPECT_NE(played_.err.find(message), std::string::npos) << played_.err;
    EXPECT_TRUE(result_["winner"].is_null());
  }

  void expect_failed(const std::string& process, const std::string& last_output_line) const {
    const json& failure = result_["failure"];
    ASSERT_TRUE(failure.is_object()) << played_.err;
    EXPECT_EQ(failure["process"], process);
    const std::string output = failure["output"].dump();
    EXPECT_NE(output.find(last_output_line), std::string::npos) << output;
    EXPECT_NE(played_.err.find("  " + process + ": "), std::string::npos) << played_.err;
  }

  cls::tests::TemporaryFolder folder_;
  const std::string mark_ = cls::tests::new_mark();
  std::string left_ = "mock:hold";
  CommandResult played_;
  json result_;
  std::chrono::steady_clock::duration took_{};
};

using ServerFault = NetworkMatch;
using TeamFault = NetworkMatch;

TEST_F(NetworkMatch, PlaysOnServerProgram) {
  play("mock", server(""), {"--half-time", "3"});
  expect_finished();
  EXPECT_EQ(played_.err, "");
  EXPECT_EQ(result_["cycles"], 60);
  EXPECT_EQ(result_["mode"], "synch");
  EXPECT_EQ(result_["server"]["version"], "19.0.0");
  EXPECT_EQ(result_["server"]["seed"], 1234);
  EXPECT_FALSE(result_["deterministic"]);
  EXPECT_EQ(result_["processes"][0]["name"], "soccer server");
  EXPECT_EQ(result_["processes"][0]["exit"], "exit code 0");
  EXPECT_GT(result_["processes"][0]["cpu_seconds"], 0.0);
  for (const char* side : {"left", "right"}) {
    for (const auto& player : result_[side]["players"]) {
      EXPECT_EQ(player["missed"], 0);
      EXPECT_EQ(player["undecided"], 0);
    }
  }
  const std::string events = cls::tests::read_file(match_folder() + "/events.jsonl");
  EXPECT_NE(events.find("\"mode\":\"kick_off_l\""), std::string::npos) << events;
}

TEST_F(NetworkMatch, StopsAtRequestedCycle) {
  play("mock", server(""), {"--cycles", "25"});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 25);
}

TEST_F(NetworkMatch, PlaysOnEmbeddedServerOverUdp) {
  play("mock", "embedded", {"--mode", "synch", "--cycles", "25"});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 25);
  EXPECT_EQ(result_["server"]["seed"], 7);
}

TEST_F(NetworkMatch, PlaysOnEmbeddedServerInRealTime) {
  play("mock", "embedded", {"--mode", "realtime", "--half-time", "1"});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 20);
  EXPECT_EQ(result_["mode"], "realtime");
}

TEST_F(NetworkMatch, PlaysOnRunningServer) {
  Command running({cls::tests::cls_binary(), "server", "--port", "0", "--dir", folder_.path(),
                   "server::synch_mode=on", "server::auto_mode=on", "server::half_time=3",
                   "server::kick_off_wait=3", "server::nr_extra_halfs=0",
                   "server::penalty_shoot_outs=off"});
  ASSERT_TRUE(running.wait_for_output("Hit CTRL-C"));
  const std::string line = running.out().substr(0, running.out().find('\n'));
  const std::size_t port = line.find(':') + 1;
  play("mock", "127.0.0.1:" + line.substr(port, line.find(',') - port), {}, {});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 60);
  EXPECT_EQ(result_["mode"], "synch");
  EXPECT_TRUE(result_["log_files"]["rcg"].is_null());
  EXPECT_TRUE(result_["server"]["cpu_seconds"].is_null());
  EXPECT_EQ(running.finish().exit_code, 0);
}

TEST_F(NetworkMatch, StartsAndStopsExternalTeam) {
  play(team(""), server(""), {"--cycles", "25", "--right-name", "Guests"});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 25);
  EXPECT_EQ(result_["right"]["name"], "Guests");
  EXPECT_GT(result_["right"]["cpu_seconds"], 0.0);
  EXPECT_EQ(result_["processes"][1]["name"], "right team");
}

// The limit of the shell fails the server's writes as a full disk does.
TEST_F(NetworkMatch, TakesScoreFromPlayersWhenServerCannotWriteItsLog) {
  const std::string limited = script(
      "limited", "ulimit -f 600\nexec " + cls::tests::cls_binary().string() + " server \"$@\"");
  left_ = "mock";
  play("mock:hold", limited, {"--cycles", "250", "--mode", "synch"});
  EXPECT_EQ(played_.exit_code, 74) << played_.err;
  EXPECT_EQ(result_["end_reason"], "finished");
  EXPECT_GE(result_["cycles"], 245) << "a loaded host may miss the last cycles";
  const std::string server = cls::tests::read_file(match_folder() + "/server.log");
  const std::size_t score = server.find("Score: ");
  ASSERT_NE(score, std::string::npos) << server;
  EXPECT_EQ(server.substr(score, server.find('\n', score) - score),
            "Score: " + result_["left"]["score"].dump() + " - " + result_["right"]["score"].dump());
  const std::string warning = result_["warnings"].back();
  EXPECT_NE(warning.find("match.rcg ends at cycle "), std::string::npos) << warning;
  EXPECT_NE(warning.find(" (the soccer server could not write its logs: "), std::string::npos)
      << warning;
  EXPECT_NE(warning.find("match.rcg': File too large"), std::string::npos) << warning;
}

TEST_F(NetworkMatch, KnowsNoResultOfExternalTeamsWhenServerCannotWriteItsLog) {
  const std::string limited =
      script("limited", "ulimit -f 20\nexec " + built("cls_fake_server") + " \"$@\"");
  left_ = team("");
  play(left_, limited, {"--half-time", "3"});
  expect_end("server_failed", 1, "the result is unknown: ");
}

// Logs contain no cycles of a stopped clock and are written in blocks: for such a short match the
// server writes nothing before its end.
TEST_F(NetworkMatch, StoppedClockBeforeKickOffIsNoStall) {
  left_ = team("");
  play(left_, server(""), {"--half-time", "1", "--stall-after", "1"},
       {"--set", "server::kick_off_wait=60"});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 20);
  EXPECT_GT(took_, 60 * 50ms) << "the clock was not stopped long enough for this test";
}

TEST_F(NetworkMatch, WarnsWhenDeadlineExceedsServerTimeout) {
  play("mock", server(""), {"--cycles", "5", "--rpc-deadline", "5000"});
  expect_finished();
  EXPECT_EQ(
      played_.err.find("cls: warning: --rpc-deadline 5000 ms: a soccer server in synchronous mode "
                       "continues without a reply after 1250 ms\n"),
      0U)
      << played_.err;
}

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

TEST_F(NetworkMatch, StartsAgentsInSequence) {
  const cls::tests::PortLock lock;
  script("team/kill", "echo ended > killed");
  play(team_of_single_agents(""), server(""), {"--cycles", "25"});
  if (played_.exit_code == 75) GTEST_SKIP() << played_.err;
  expect_finished();
  EXPECT_EQ(result_["right"]["name"], "Guests");
  ASSERT_EQ(result_["processes"].size(), 14U);
  EXPECT_EQ(result_["processes"][13]["name"], "right kill script");
  EXPECT_EQ(result_["processes"][7]["name"], "right player 7");
  EXPECT_NE(result_["processes"][7]["command"].get<std::string>().find("/start 127.0.0.1 "),
            std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "team/killed"));
}

TEST_F(NetworkMatch, ReportsOwnerOfPortInUse) {
  const cls::tests::PortLock lock;
  script("team/start", "exit 1");
  Command owner({built("cls_fake_process"), "bind-udp", "6001", "print", "bound", "hang"});
  if (!owner.wait_for_output("bound")) GTEST_SKIP() << "port 6001 is in use by another process";
  play("team:" + (folder_.path() / "team").string(), server(""));
  expect_end("refused", 75, "UDP port 600");
  EXPECT_NE(played_.err.find("is taken by "), std::string::npos) << played_.err;
}

TEST_F(NetworkMatch, DryRunPrintsCommands) {
  Arguments argv = arguments(team(""), server(""), {"--dry-run"});
  const auto printed = cls::tests::run(argv);
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  for (const char* part :
       {"# soccer server\ncd ", "RCSS_CONF_DIR=", "server::synch_mode=on",
        "# left Playmaker: mock:hold\n", "# right team", " && env -i ", "/start.sh -h "}) {
    EXPECT_NE(printed.out.find(part), std::string::npos) << part << " in\n" << printed.out;
  }
  EXPECT_FALSE(std::filesystem::exists(match_folder()));
}

TEST_F(ServerFault, ReportsMissingProgram) {
  play("mock", "/no/such/server");
  expect_end("refused", 69, "soccer server /no/such/server: no such file");
}

TEST_F(ServerFault, ReportsExitAtStart) {
  play("mock", server("--exit-at-start 1"));
  expect_end(
      "refused", 69,
      "the soccer server ended before the match: exit code 1 (Error: the stadium is closed)");
  expect_failed("soccer server", "the stadium is closed");
  EXPECT_LT(took_, 5s);
}

TEST_F(ServerFault, ReportsPortNotOpened) {
  play("mock", server("--never-open 1"), {"--start-timeout", "1"});
  expect_end("refused", 69, "did not open UDP port ");
  expect_failed("soccer server", "Simulator Random Seed");
}

TEST_F(ServerFault, ReportsDifferentPort) {
  play("mock", server("--port-offset 1"), {"--start-timeout", "1"});
  expect_end("refused", 69, " (but port ");
}

TEST_F(ServerFault, ReportsMissingReply) {
  play("mock", server("--silent 1"), {"--start-timeout", "1"});
  expect_end("refused", 69, "could not join the match within the start limit of 1 s");
}

TEST_F(ServerFault, ReportsSegfaultDuringMatch) {
  play("mock", server("--until-cycle 20 --signal 11"));
  expect_end("server_failed", 1, "the soccer server ended at cycle 20: killed by SIGSEGV");
  EXPECT_EQ(result_["cycles"], 20);
}

TEST_F(ServerFault, ReportsExitCodeDuringMatch) {
  play("mock", server("--until-cycle 20 --code 3"));
  expect_end("server_failed", 1, "the soccer server ended at cycle 20: exit code 3");
}

TEST_F(ServerFault, ReportsExitZeroDuringMatch) {
  play("mock", server("--until-cycle 20"));
  expect_end("server_failed", 1, "the soccer server ended at cycle 20: exit code 0");
}

TEST_F(ServerFault, ReportsHangDuringMatch) {
  play("mock", server("--until-cycle 20 --then-hang 1"), {"--stall-after", "1"});
  expect_end("stalled", 1, "no new cycle for 1 s");
}

TEST_F(ServerFault, ContinuesDespiteFloodOfOutput) {
  play("mock", server("--flood 1"), {"--cycles", "10"});
  expect_finished();
  EXPECT_LT(std::filesystem::file_size(match_folder() + "/server.log"), 5000U);
}

TEST_F(ServerFault, KillsServerThatIgnoresSigterm) {
  play("mock", server("--ignore-term 1"), {"--cycles", "10"});
  // Killed, it did not write the rest of its log; the agents know the result.
  EXPECT_EQ(played_.exit_code, 74) << played_.err;
  EXPECT_EQ(result_["end_reason"], "finished");
  EXPECT_EQ(result_["cycles"], 9);
  EXPECT_NE(played_.err.find("match.rcg ends at cycle "), std::string::npos) << played_.err;
  EXPECT_EQ(result_["processes"][0]["exit"], "ended by cls (killed by SIGKILL)");
}

TEST_F(ServerFault, KillsGrandchildOfServer) {
  play("mock", server("--grandchild 1"), {"--cycles", "10"});
  expect_finished();
}

TEST_F(ServerFault, ReportsUnreachableAddress) {
  play("mock", "127.0.0.1:9", {"--start-timeout", "1"}, {});
  expect_end("refused", 69, "no soccer server answers at 127.0.0.1:9 within the start limit");
}

// Another process binds the port after it was chosen.
TEST_F(ServerFault, ReportsPortInUse) {
  const std::string bound = folder_.path() / "bound";
  const std::string program = script(
      "server",
      "for argument; do case $argument in server::port=*) port=${argument#*=};; esac; done\n" +
          built("cls_fake_process") + " bind-udp $port print bound hang > " + bound +
          " &\nwhile ! [ -s " + bound + " ]; do sleep 0.01; done\nexec " +
          built("cls_fake_server") + " \"$@\"");
  play("mock", program);
  expect_end("refused", 69, "the soccer server ended before the match: exit code 1");
  expect_failed("soccer server", "");
}

/// A server that changes its log after the match.
std::string then(const std::string& deed) {
  return built("cls_fake_server") + " \"$@\"\ncode=$?\n" + deed + "\nexit $code";
}

TEST_F(ServerFault, WarnsWhenLogAndPlayersDisagreeOnScore) {
  play("mock",
       script("server", then("sed -i 's/ hold mock [0-9]* [0-9]*)/ hold mock 7 8)/' match.rcg")),
       {"--half-time", "2"});
  expect_finished();
  EXPECT_EQ(result_["left"]["score"], 7);
  EXPECT_EQ(result_["right"]["score"], 8);
  EXPECT_NE(played_.err.find("the log says 7 : 8, but the players of hold counted "),
            std::string::npos)
      << played_.err;
}

TEST_F(ServerFault, TakesScoreFromPlayersWithoutLog) {
  play("mock", script("server", then("rm match.rcg")), {"--half-time", "2"});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 40);
  EXPECT_TRUE(result_["log_files"]["rcg"].is_null());
  EXPECT_NE(played_.err.find("score and cycles are those that the cls agents heard: "),
            std::string::npos)
      << played_.err;
}

TEST_F(ServerFault, FailsWithoutLogAndPlayers) {
  left_ = team("");
  play(left_, script("server", then("rm match.rcg")), {"--half-time", "1"});
  expect_end("server_failed", 1, "the result is unknown: ");
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

// The cls agents have replied to every cycle, so the server gave up waiting for the others.
TEST_F(TeamFault, BlamesTheTeamThatTheServerGaveUp) {
  play(team(""), server("--until-cycle 20 --give-up 1 --code 1"), {"--right-name", "Guests"});
  expect_end("late", 1, "clients stopped responding: those of Guests (team:");
  EXPECT_EQ(result_["fault"], "right");
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

TEST_F(TeamFault, AcceptsOwnNameOfTeam) {
  play(team("--name Others"), server(""), {"--cycles", "10"});
  expect_finished();
  EXPECT_EQ(result_["right"]["name"], "Others");
  EXPECT_NE(played_.err.find("plays under the name Others instead of team"), std::string::npos)
      << played_.err;
}

TEST_F(TeamFault, AcceptsDisconnectAtTimeOver) {
  play(team("--exit-at-cycle 60 --code 0"), server(""), {"--half-time", "3"});
  expect_finished();
  EXPECT_EQ(result_["cycles"], 60);
}

TEST_F(TeamFault, ReportsCrashOfOneAgent) {
  const cls::tests::PortLock lock;
  play(team_of_single_agents("--exit-at-cycle 10"), server(""));
  if (played_.exit_code == 75) GTEST_SKIP() << played_.err;
  expect_end("crashed", 1, "the process of right player 7 ended at cycle ");
  expect_failed("right player 7", "lost my boots");
  EXPECT_EQ(result_["failure"]["exit"], "exit code 4");
}

TEST_F(TeamFault, ReportsAgentThatNeverConnects) {
  const cls::tests::PortLock lock;
  play(team_of_single_agents("--never-join 1"), server(""), {"--start-timeout", "2"});
  if (played_.exit_code == 75) GTEST_SKIP() << played_.err;
  expect_end("refused", 69, "right player 7 has not joined within the start limit");
  EXPECT_EQ(result_["failure"]["process"], "right player 7");
}

TEST_F(TeamFault, ReportsAgentThatConnectsTwoPlayers) {
  const cls::tests::PortLock lock;
  play(team_of_single_agents("--players 2"), server(""));
  if (played_.exit_code == 75) GTEST_SKIP() << played_.err;
  expect_end("refused", 69, "right player 7 brought players 1, 2, 3, 4, 5, 6, 7, 8 onto the pitch");
}

TEST_F(TeamFault, AcceptsOwnNameWithOwnNamesOption) {
  const cls::tests::PortLock lock;
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
  EXPECT_EQ(played_.err.find("line 95\n"), std::string::npos) << played_.err;
  EXPECT_NE(played_.err.find("  right team: line 96\n"), std::string::npos) << played_.err;
  EXPECT_NE(played_.err.find("  right team: line 100\n"), std::string::npos) << played_.err;
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
  expect_end("refused", 69, "it does not listen on port");
}

/// Waits until the match writes its log.
void wait_for_play(const std::string& folder) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string log = folder + "/match.rcg";
  while (std::chrono::steady_clock::now() - begin < 20s &&
         !(std::filesystem::exists(log) && std::filesystem::file_size(log) > 100'000)) {
    std::this_thread::sleep_for(20ms);
  }
}

TEST_F(NetworkMatch, StopsCleanlyAfterSignal) {
  const std::vector<std::pair<int, int>> cases = {{SIGINT, 130}, {SIGTERM, 143}};
  for (const auto& [signal, exit_code] : cases) {
    std::filesystem::remove_all(match_folder());
    Command command(arguments(team("--ignore-term 1"), server("--ignore-term 1"), {}),
                    environment());
    wait_for_play(match_folder());
    command.send_signal(signal);
    const auto begin = std::chrono::steady_clock::now();
    const CommandResult ended = command.finish();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
    EXPECT_EQ(ended.exit_code, exit_code) << ended.err;
    EXPECT_TRUE(cls::tests::marked_processes(mark_).empty());
    const json result = json::parse(cls::tests::read_file(match_folder() + "/result.json"));
    EXPECT_EQ(result["end_reason"], "interrupted");
    EXPECT_GT(result["cycles"], 0);
  }
}

TEST_F(NetworkMatch, LeavesNoProcessAfterSignalAtStart) {
  Command command(
      arguments(team("--never-join 1 --ignore-term 1"), server(""), {"--start-timeout", "60"}),
      environment());
  const auto begin = std::chrono::steady_clock::now();
  while (cls::tests::marked_processes(mark_).size() < 14 &&
         std::chrono::steady_clock::now() - begin < 40s) {
    std::this_thread::sleep_for(10ms);
  }
  command.send_signal(SIGINT);
  const CommandResult ended = command.finish();
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_TRUE(cls::tests::marked_processes(mark_).empty());
  const json result = json::parse(cls::tests::read_file(match_folder() + "/result.json"));
  EXPECT_EQ(result["end_reason"], "interrupted");
  EXPECT_EQ(result["cycles"], 0);
}

TEST_F(NetworkMatch, LeavesNoProcessAfterSigkill) {
  Command command(arguments(team("--ignore-term 1 --grandchild 1"),
                            server("--ignore-term 1 --grandchild 1"), {}),
                  environment());
  wait_for_play(match_folder());
  EXPECT_GT(cls::tests::marked_processes(mark_).size(), 20U);
  command.send_signal(SIGKILL);
  EXPECT_TRUE(cls::tests::all_marked_gone(mark_, 2s));
}

TEST_F(NetworkMatch, StopsAtTimeLimit) {
  play("mock", server(""), {"--time-limit", "2"});
  expect_end("timed_out", 124, "the time limit of 2 s was reached");
}

TEST(MatchOptions, RejectsSettingsOfRunningServer) {
  const auto answer = cls::tests::run({cls::tests::cls_binary(), "match", "mock", "team:x",
                                       "--half-time", "3", "--server", "localhost:6000"});
  EXPECT_EQ(answer.exit_code, 2);
  EXPECT_NE(answer.err.find("the server at localhost:6000 has settings of its own"),
            std::string::npos);
  EXPECT_NE(answer.err.find("side 'team:x' requires a server started by cls"), std::string::npos);
}

TEST(MatchOptions, LockstepRejectsExternalServerAndTeam) {
  const auto answer = cls::tests::run({cls::tests::cls_binary(), "match", "mock", "team:x",
                                       "--mode", "lockstep", "--server", "rcssserver"});
  EXPECT_EQ(answer.exit_code, 2);
  EXPECT_NE(answer.err.find("--mode lockstep needs the embedded server"), std::string::npos);
  EXPECT_NE(answer.err.find("--mode lockstep does not support side 'team:x'"), std::string::npos);
}

}  // namespace
