// End-to-end tests of `cls match`: results, files, exit codes, errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <string.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_client.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using json = base::Json;

// A short match without a long wait before kick-off.
std::vector<std::string> match(const std::vector<std::string>& more, const fs::path& folder) {
  std::vector<std::string> arguments = joined({cls_binary(), "match"}, more);
  for (const char* argument : {"--set", "server::kick_off_wait=3", "--dir"}) {
    arguments.push_back(argument);
  }
  arguments.push_back(folder);
  return arguments;
}

int lines_in(const std::string& text) { return static_cast<int>(std::ranges::count(text, '\n')); }

/// A port that was free when tested; the server reports if it is in use since.
int free_udp_port() {
  UdpClient probe(1);
  return probe.own_port();
}

json result_in(const fs::path& folder) { return json::parse(read_file(folder / "result.json")); }

TEST(MatchCommand, WritesMatchFolder) {
  TemporaryFolder folder;
  const CommandResult played =
      run(match({"mock", "mock", "--seed", "7", "--cycles", "100"}, folder.path()));
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.err, "");  // no terminal, so no progress line
  EXPECT_EQ(played.out.substr(0, 7), "mock_l ");

  for (const char* file :
       {"result.json", "manifest.json", "events.jsonl", "match.rcg", "match.rcl"}) {
    EXPECT_TRUE(fs::exists(folder.path() / file)) << file;
  }

  const json result = result_in(folder.path());
  EXPECT_EQ(result["end_reason"], "finished");
  EXPECT_EQ(result["cycles"], 100);
  EXPECT_EQ(result["valid"], true);
  EXPECT_EQ(result["deterministic"], true);
  EXPECT_EQ(result["left"]["players"].size(), 11u);
  EXPECT_EQ(result["left"]["players"][0]["missed"], 0);
  EXPECT_GE(result["left"]["players"][0]["decisions"], 100);
}

TEST(MatchCommand, PrintsOnlyResultFileWithJson) {
  TemporaryFolder folder;
  const CommandResult played =
      run(match({"mock", "mock:hold", "--cycles", "30", "--json"}, folder.path()));
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.out, read_file(folder.path() / "result.json"));
  EXPECT_EQ(json::parse(played.out)["right"]["name"], "hold");
}

TEST(MatchCommand, UsesHalfTimeOption) {
  TemporaryFolder folder;
  EXPECT_THAT(run(match({"mock", "mock", "--half-time", "5", "--seed", "3"}, folder.path())),
              Exits(0));
  EXPECT_EQ(result_in(folder.path())["cycles"], 100);
  EXPECT_THAT(read_file(folder.path() / "events.jsonl"), HasSubstr("time_over"));
}

struct UsageError {
  std::vector<std::string> arguments;
  std::string message;
};

TEST(MatchCommand, ReportsUsageErrorsInOneLine) {
  const std::vector<UsageError> errors = {
      {{"mock", "mock", "--sed", "7"}, "cls: unknown option '--sed'; did you mean '--seed'?\n"},
      {{"moc", "mock"}, "cls: unknown side 'moc'; did you mean 'mock'?"},
      {{"drill.json", "mock"}, "unknown side 'drill.json'; did you mean 'mock:drill.json'?"},
      {{"REDS", "mock"}, "names of teams need a cls.toml here or above, or --config FILE\n"},
      {{"mock", "mock:hodl"}, "cls: unknown mock behavior 'hodl'; did you mean 'hold'?\n"},
      {{"mock", "localhost:99999"}, "port 99999 is not within 1 to 65535\n"},
      {{"mock"}, "cls: RIGHT is required (see cls match --help)\n"},
      {{"mock", "mock", "mock"}, "cls: unknown argument 'mock'"},
      {{"mock", "mock", "--seed", "x"}, "--seed"},
      {{"mock", "mock", "--cycles", "0"}, "cls: --cycles '0': must be a whole number from 1\n"},
      {{"mock", "mock", "--set", "server::half_tine=3"},
       "cls: --set: unknown parameter 'half_tine'; did you mean 'half_time'?\n"},
      {{"mock", "mock", "--set", "server::half_time=x"},
       "cls: --set: parameter 'half_time': 'x' is not a whole number\n"},
      {{"mock", "mock", "--left-name", "two words"}, "only letters, digits"},
      {{"mock", "mock", "--server", "rcsserver"},
       "cls: --server 'rcsserver': did you mean 'rcssserver'?"},
      {{"mock", "mock", "--mode", "realtime", "--speed", "2"},
       "cls: --speed needs --mode lockstep or synch and a side with a Playmaker"},
      {{"mock", "mock", "--server", "rcssserver", "--step"},
       "cls: --step and --at need the embedded server, --mode lockstep or synch"},
      {{"mock", "mock", "--speed", "0"}, "cls: --speed '0': must be a number from 0.1 to 1000\n"},
      {{"mock", "mock", "--monitor-port", "70000"},
       "cls: --monitor-port '70000': must be a whole number from 0 to 65535\n"},
      {{"mock", "mock", "--on-late", "hodl"},
       "cls: --on-late 'hodl': must be hold, last or default; did you mean 'hold'?\n"},
  };

  for (const UsageError& error : errors) {
    TemporaryFolder folder;
    const fs::path target = folder.path() / "match";
    const CommandResult refused = run(match(error.arguments, target));
    EXPECT_EQ(refused.exit_code, 2) << error.message;
    EXPECT_EQ(refused.out, "") << error.message;
    EXPECT_THAT(refused.err, HasSubstr(error.message));
    EXPECT_EQ(lines_in(refused.err), 1) << refused.err;
    EXPECT_FALSE(fs::exists(target)) << "nothing is written after a usage error";
  }
}

TEST(MatchCommand, MonitorDoesNotChangeTheMatch) {
  TemporaryFolder alone;
  TemporaryFolder watched;
  const std::vector<std::string> argv = {"mock", "mock", "--seed", "7", "--cycles", "60"};
  ASSERT_EQ(run(match(argv, alone.path())).exit_code, 0);

  auto more = argv;
  const int port = free_udp_port();
  more.insert(more.end(), {"--monitor-port", std::to_string(port), "--speed", "20"});
  Command running(match(more, watched.path()));
  UdpClient monitor(port);
  std::string message;
  for (int i = 0; i < 1000 && message.empty(); ++i) {
    monitor.send("(dispinit version 5)");
    message = monitor.wait(std::chrono::milliseconds(20));
  }

  EXPECT_TRUE(message.starts_with("(server_param ")) << message;
  monitor.send("(dispfoul 0 0 1)");
  while (!message.starts_with("(show 5 ") && !(message = monitor.wait()).empty()) {
  }
  EXPECT_THAT(message, HasSubstr("(tm mock_l mock_r 0 0)"));

  UdpClient player(port);
  player.send("(init A (version 18))");
  EXPECT_EQ(player.wait(), "(error unknown_command)");
  EXPECT_THAT(running.finish(),
              Exits(0, HasSubstr("cls: monitors may attach at 127.0.0.1:" + std::to_string(port))));
  EXPECT_EQ(read_file(watched.path() / "match.rcg"), read_file(alone.path() / "match.rcg"));
  EXPECT_EQ(result_in(watched.path())["deterministic"], true);
  // 60 cycles and the few steps before the kick-off, 5 ms each.
  EXPECT_GE(result_in(watched.path())["wall_seconds"], 0.3);
}

TEST(MatchCommand, ReportsAllErrorsTogether) {
  TemporaryFolder folder;
  const CommandResult refused = run(match({"moc", "hold", "--cycles", "-1"}, folder.path()));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(lines_in(refused.err), 3) << refused.err;
}

TEST(MatchCommand, ReportsFolderThatCannotBeCreated) {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  const CommandResult refused = run(match({"mock", "mock"}, folder.path() / "file" / "match"));
  EXPECT_EQ(refused.exit_code, 73);
  EXPECT_EQ(lines_in(refused.err), 1) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("cannot create folder"));
  EXPECT_THAT(refused.err, HasSubstr("file/match"));
}

TEST(MatchCommand, FinishesMatchWhenDiskIsFull) {
  TemporaryFolder folder;
  std::string line = "ulimit -f 200; exec";  // blocks of 512 bytes: 100 KiB a file
  for (const std::string& argument : match({"mock", "mock", "--cycles", "200"}, folder.path())) {
    line += " '" + argument + "'";
  }
  EXPECT_THAT(run({"sh", "-c", line}), Exits(74, HasSubstr("match.rcg")));
  EXPECT_EQ(result_in(folder.path())["cycles"], 200);
}

TEST(MatchCommand, ReportsUnreachablePlaymakerAfterStartTimeout) {
  TemporaryFolder folder;
  const auto start = std::chrono::steady_clock::now();
  const CommandResult refused =
      run(match({"mock", "127.0.0.1:1", "--start-timeout", "2"}, folder.path()));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_EQ(refused.exit_code, 69);
  EXPECT_EQ(lines_in(refused.err), 1) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("127.0.0.1:1"));
  const json result = result_in(folder.path());
  EXPECT_EQ(result["end_reason"], "refused");
  EXPECT_EQ(result["valid"], false);
  EXPECT_TRUE(result["winner"].is_null());
}

struct Interruption {
  int signal;
  int exit_code;
};

void PrintTo(const Interruption& one, std::ostream* out) { *out << strsignal(one.signal); }

class Interrupted : public testing::TestWithParam<Interruption> {};

TEST_P(Interrupted, StopsCleanlyAndWritesLogs) {
  TemporaryFolder folder;
  Command playing(match({"mock", "mock", "--seed", "7"}, folder.path()));
  const fs::path growing = folder.path() / "match.rcg";
  for (int i = 0;
       i < 1000 && (!fs::exists(growing) || read_file(growing).find("(show ") == std::string::npos);
       ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  playing.send_signal(GetParam().signal);
  const CommandResult ended = playing.finish(std::chrono::seconds(5));
  EXPECT_EQ(ended.exit_code, GetParam().exit_code) << ended.err;

  const json result = result_in(folder.path());
  EXPECT_EQ(result["end_reason"], "interrupted");
  EXPECT_GT(result["steps"], 0);

  const std::string game_log = read_file(folder.path() / "match.rcg");
  EXPECT_EQ(game_log.substr(0, 5), "ULG6\n");
  EXPECT_THAT(game_log, HasSubstr("(result ")) << "the log is complete";
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted,
                         testing::Values(Interruption{SIGINT, 130}, Interruption{SIGTERM, 143}));

TEST(MatchCommand, StopsAtTimeLimit) {
  TemporaryFolder folder;
  EXPECT_THAT(run(match({"mock", "mock", "--time-limit", "0.5"}, folder.path())), Exits(124));
  EXPECT_EQ(result_in(folder.path())["end_reason"], "timed_out");
}

}  // namespace
}  // namespace cls::tests
