// Matches over UDP with external servers and teams that work, and their ends.
#include "tests/cli/network_match.h"
#include "tests/support/command_matchers.h"

#include <gmock/gmock.h>
#include <signal.h>

#include <thread>

#include "tests/support/port_lock.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;
using json = base::Json;
using Arguments = std::vector<std::string>;

TEST_F(NetworkMatch, PlaysOnServerProgram) {
  play("mock", server(""), {"--half-time", "3"});
  expect_finished();
  EXPECT_EQ(played_.err, "");
  EXPECT_EQ(result_["cycles"], 60);
  EXPECT_EQ(result_["mode"], "synch");
  EXPECT_EQ(result_["server"]["version"], "19.0.0");
  EXPECT_EQ(result_["server"]["seed"], 1234);
  EXPECT_EQ(result_["deterministic"], false);
  EXPECT_EQ(result_["processes"][0]["name"], "soccer server");
  EXPECT_EQ(result_["processes"][0]["exit"], "exit code 0");
  EXPECT_GT(result_["processes"][0]["cpu_seconds"], 0.0);

  for (const char* side : {"left", "right"}) {
    for (const auto& player : result_[side]["players"]) {
      EXPECT_EQ(player["missed"], 0);
      EXPECT_EQ(player["undecided"], 0);
    }
  }

  const std::string events = read_file(match_folder() + "/events.jsonl");
  EXPECT_THAT(events, HasSubstr("\"mode\":\"kick_off_l\""));
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
  Command running({cls_binary(), "server", "--port", "0", "--dir", folder_.path(),
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
TEST_F(NetworkMatch, KnowsNoResultWhenServerCannotWriteItsLog) {
  const std::string limited =
      script("limited", "ulimit -f 600\nexec " + cls_binary().string() + " server \"$@\"");
  left_ = "mock";
  play("mock:hold", limited, {"--cycles", "250", "--mode", "synch"});
  expect_end("server_failed", 74, "the result is unknown: match.rcg ends at cycle ");
  EXPECT_GE(result_["cycles"], 245) << "a loaded host may miss the last cycles";

  const auto message = result_["message"].get<std::string>();
  EXPECT_THAT(message, HasSubstr(" (the soccer server could not write its logs: "));
  EXPECT_THAT(message, HasSubstr("match.rcg': File too large"));
  EXPECT_THAT(message, HasSubstr("; the cls agents heard "));
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

TEST_F(NetworkMatch, StartsAgentsInSequence) {
  const PortLock lock;
  script("team/kill", "echo ended > killed");
  play(team_of_single_agents(""), server(""), {"--cycles", "25"});
  if (played_.exit_code == 75) GTEST_SKIP() << played_.err;
  expect_finished();
  EXPECT_EQ(result_["right"]["name"], "Guests");
  ASSERT_EQ(result_["processes"].size(), 14U);
  EXPECT_EQ(result_["processes"][13]["name"], "right kill script");
  EXPECT_EQ(result_["processes"][7]["name"], "right player 7");
  EXPECT_THAT(result_["processes"][7]["command"].get<std::string>(),
              HasSubstr("/start 127.0.0.1 "));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "team/killed"));
}

// In a network of its own a team finds the usual ports free.
TEST_F(NetworkMatch, ReportsOwnerOfPortInUse) {
  const PortLock lock;
  script("team/start", "exit 1");
  Command owner({built("cls_fake_process"), "bind-udp", "6001", "print", "bound", "hang"});
  if (!owner.wait_for_output("bound")) GTEST_SKIP() << "port 6001 is in use by another process";
  play("team:" + (folder_.path() / "team").string(), server(""), {"--no-sandbox"});
  expect_end("refused", 75, "UDP port 600");
  EXPECT_THAT(played_.err, HasSubstr("is taken by "));
}

TEST_F(NetworkMatch, DryRunPrintsCommands) {
  Arguments argv = arguments(team(""), server(""), {"--dry-run"});
  const auto printed = run(argv);
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  for (const char* part :
       {"# soccer server\ncd ", "RCSS_CONF_DIR=", "server::synch_mode=on",
        "# left Playmaker: mock:hold\n", "# right team", " && env -i ", "/start.sh -h "}) {
    EXPECT_THAT(printed.out, HasSubstr(part)) << part << " in\n";
  }
  EXPECT_FALSE(std::filesystem::exists(match_folder()));
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
    EXPECT_TRUE(all_marked_gone(mark_));
    const json result = json::parse(read_file(match_folder() + "/result.json"));
    EXPECT_EQ(result["end_reason"], "interrupted");
    EXPECT_GT(result["cycles"], 0);
  }
}

TEST_F(NetworkMatch, LeavesNoProcessAfterSignalAtStart) {
  Command command(
      arguments(team("--never-join 1 --ignore-term 1"), server(""), {"--start-timeout", "60"}),
      environment());
  const auto begin = std::chrono::steady_clock::now();
  while (marked_processes(mark_).size() < 14 && std::chrono::steady_clock::now() - begin < 40s) {
    std::this_thread::sleep_for(10ms);
  }
  command.send_signal(SIGINT);
  EXPECT_THAT(command.finish(), Exits(130));
  EXPECT_TRUE(all_marked_gone(mark_));
  const json result = json::parse(read_file(match_folder() + "/result.json"));
  EXPECT_EQ(result["end_reason"], "interrupted");
  EXPECT_EQ(result["cycles"], 0);
}

TEST_F(NetworkMatch, LeavesNoProcessAndNoTemporaryFolderAfterSigkill) {
  const std::filesystem::path temporary = folder_.path() / "tmp";
  std::filesystem::create_directory(temporary);
  std::vector<std::string> variables = environment();
  variables.push_back("TMPDIR=" + temporary.string());
  Command command(arguments(team("--ignore-term 1 --grandchild 1"),
                            server("--ignore-term 1 --grandchild 1"), {}),
                  variables);
  wait_for_play(match_folder());
  EXPECT_FALSE(std::filesystem::is_empty(temporary));
  EXPECT_GT(marked_processes(mark_).size(), 20U);
  command.send_signal(SIGKILL);
  EXPECT_TRUE(all_marked_gone(mark_, 2s));
  EXPECT_TRUE(std::filesystem::is_empty(temporary));
}

TEST_F(NetworkMatch, StopsAtTimeLimit) {
  play("mock", server(""), {"--time-limit", "2"});
  expect_end("timed_out", 124, "the time limit of 2 s was reached");
}

TEST(MatchOptions, RejectsSettingsOfRunningServer) {
  EXPECT_THAT(
      run({cls_binary(), "match", "mock", "team:x", "--half-time", "3", "--server",
           "localhost:6000"}),
      Exits(2, testing::AllOf(HasSubstr("the server at localhost:6000 has settings of its own"),
                              HasSubstr("side 'team:x' requires a server started by cls"))));
}

TEST(MatchOptions, LockstepRejectsExternalServerAndTeam) {
  EXPECT_THAT(
      run({cls_binary(), "match", "mock", "team:x", "--mode", "lockstep", "--server",
           "rcssserver"}),
      Exits(2, testing::AllOf(HasSubstr("--mode lockstep needs the embedded server"),
                              HasSubstr("--mode lockstep does not support side 'team:x'"))));
}

}  // namespace
}  // namespace cls::tests
