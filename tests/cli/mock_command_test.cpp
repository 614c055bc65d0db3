// `cls mock` as a separate process that matches connect to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "base/system/tcp_connect.h"
#include "base/system/unique_fd.h"
#include "tests/support/command.h"
#include "tests/support/temporary_folder.h"

namespace {

using cls::tests::Command;
using testing::HasSubstr;

TEST(MockCommand, ServesMatchOnFreePortUntilSignal) {
  Command mock({cls::tests::cls_binary(), "mock"});
  ASSERT_TRUE(mock.wait_for_output("\n"));
  const std::string line = mock.out();
  ASSERT_EQ(line.rfind("listening on 127.0.0.1:", 0), 0u) << line;
  const std::string address = line.substr(13, line.find('\n') - 13);

  cls::tests::TemporaryFolder folder;
  const auto played =
      cls::tests::run({cls::tests::cls_binary(), "match", address, "mock:hold", "--cycles", "50",
                       "--set", "server::kick_off_wait=3", "--dir", folder.path()});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  mock.send_signal(SIGTERM);
  EXPECT_EQ(mock.finish().exit_code, 143);
}

TEST(MockCommand, RejectsFaultsOfUnknownPlayers) {
  const auto mock = [](std::vector<std::string> flags) {
    flags.insert(flags.begin(), {cls::tests::cls_binary(), "mock"});
    return cls::tests::run(flags);
  };
  const auto cycles = mock({"--drop", "1", "--fault-cycles", "20", "10"});
  EXPECT_EQ(cycles.exit_code, 2);
  EXPECT_EQ(cycles.err, "cls: --fault-cycles: 20 is after 10\n");
  const auto number = mock({"--drop", "1", "--fault-unum", "7,14"});
  EXPECT_EQ(number.exit_code, 2);
  EXPECT_EQ(number.err,
            "cls: --fault-unum: 14 is not a uniform number (1 to 11, 12 coach, 13 trainer)\n");
}

TEST(MockCommand, ReportsUnknownBehaviorsAndPortsInUse) {
  const auto unknown = cls::tests::run({cls::tests::cls_binary(), "mock", "hodl"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.err, "cls: unknown mock behavior 'hodl'; did you mean 'hold'?\n");

  Command mock({cls::tests::cls_binary(), "mock"});
  ASSERT_TRUE(mock.wait_for_output("\n"));
  const std::string line = mock.out();
  const std::string port = line.substr(line.rfind(':') + 1, line.find('\n') - line.rfind(':') - 1);
  const auto taken = cls::tests::run({cls::tests::cls_binary(), "mock", "--port", port});
  EXPECT_EQ(taken.exit_code, 75);
  EXPECT_THAT(taken.err, HasSubstr("TCP port " + port + " is taken by cls")) << taken.err;
}

// Plays cycles of the Playmaker at `address` against a mock that holds.
cls::tests::CommandResult play_at(const std::string& address,
                                  const std::vector<std::string>& more = {},
                                  const std::string& cycles = "30") {
  cls::tests::TemporaryFolder folder;
  std::vector<std::string> match = {cls::tests::cls_binary(),
                                    "match",
                                    address,
                                    "mock:hold",
                                    "--cycles",
                                    cycles,
                                    "--set",
                                    "server::kick_off_wait=3",
                                    "--dir",
                                    folder.path(),
                                    "--rpc-deadline",
                                    "300"};
  match.insert(match.end(), more.begin(), more.end());
  return cls::tests::run(match);
}

std::string address_of(const Command& mock) {
  const std::string line = mock.out();
  return line.substr(13, line.find('\n') - 13);
}

// Plays 30 cycles of `mock` (started with these flags) against a mock that holds.
cls::tests::CommandResult play_against(std::vector<std::string> flags,
                                       const std::vector<std::string>& more = {}) {
  flags.insert(flags.begin(), {cls::tests::cls_binary(), "mock"});
  Command mock(flags);
  EXPECT_TRUE(mock.wait_for_output("\n"));
  return play_at(address_of(mock), more);
}

TEST(MockCommand, MatchReportsProcessFaults) {
  const auto crashed = play_against({"--crash-at-cycle", "10"});
  EXPECT_EQ(crashed.exit_code, 1);
  EXPECT_THAT(crashed.err, HasSubstr("no usable reply")) << crashed.err;
  const auto failing = play_against({"--error", "1", "--status", "DATA_LOSS"});
  EXPECT_EQ(failing.exit_code, 1);
  EXPECT_THAT(failing.err, HasSubstr("injected error")) << failing.err;
  const auto dropping = play_against({"--drop", "0.02", "--fault-unum", "4"});
  EXPECT_EQ(dropping.exit_code, 0) << dropping.err;
}

// Replies to agents that do not register again are tested in tests/mock-server.
TEST(MockCommand, ListensAgainAfterRestart) {
  Command mock(
      {cls::tests::cls_binary(), "mock", "--restart-at-cycle", "10", "--restart-after", "0"});
  ASSERT_TRUE(mock.wait_for_output("\n"));
  const auto played = play_at(address_of(mock), {"--max-missed", "1000"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(played.err, HasSubstr("connection to the Playmaker lost")) << played.err;
  const auto again = play_at(address_of(mock), {}, "5");
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

// A listener of gRPC that once found no free descriptor never accepts again.
TEST(MockCommand, AcceptsMatchesAfterMoreConnectionsThanItsSoftLimit) {
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  if (limit.rlim_max < 1000) GTEST_SKIP() << "needs 1000 descriptors, " << limit.rlim_max;
  rlimit low = limit;
  low.rlim_cur = 64;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &low), 0);
  Command mock({cls::tests::cls_binary(), "mock"});
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &limit), 0);
  ASSERT_TRUE(mock.wait_for_output("\n"));
  const std::string address = address_of(mock);
  const int port = std::stoi(address.substr(address.rfind(':') + 1));
  {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    std::vector<cls::base::UniqueFd> idle;
    for (int i = 0; i < 120; ++i) {
      idle.push_back(cls::base::connect_tcp("127.0.0.1", port, deadline));
      ASSERT_TRUE(idle.back()) << i;
    }
    const auto beside = play_at(address, {}, "5");
    EXPECT_EQ(beside.exit_code, 0) << beside.err;
  }
  const auto after = play_at(address, {}, "5");
  EXPECT_EQ(after.exit_code, 0) << after.err;
}

TEST(MockCommand, ReportsFailedExpectationsOfScript) {
  cls::tests::TemporaryFolder folder;
  const std::string script = folder.path() / "script.json";
  std::ofstream(script) << "{\"expect\": [{\"rpc\": \"Register\", \"count\": 13}]}";
  cls::tests::TemporaryFolder match;
  const auto played =
      cls::tests::run({cls::tests::cls_binary(), "match", "mock:" + script, "mock:hold", "--cycles",
                       "5", "--set", "server::kick_off_wait=3", "--dir", match.path()});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(played.err, HasSubstr("script: expected (line 1): 12 calls of Register, not == 13"))
      << played.err;
}

TEST(MockCommand, SaysWhyItCannotListenAtHost) {
  for (const auto& [host, why] : {std::pair("bad host", "cannot be resolved: "),
                                  std::pair("192.0.2.1", "not an address of this host; ")}) {
    const auto refused = cls::tests::run({cls::tests::cls_binary(), "mock", "--host", host});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.err.find(std::string("cls: --host '") + host + "': " + why), 0u)
        << refused.err;
  }
}

TEST(MockCommand, ReportsInvalidAndMissingScripts) {
  cls::tests::TemporaryFolder folder;
  const std::string script = folder.path() / "script.json";
  std::ofstream(script) << "{\n  \"ruls\": []\n}";
  for (const auto& command : {std::vector<std::string>{"mock", script},
                              std::vector<std::string>{"match", "mock:" + script, "mock"}}) {
    std::vector<std::string> arguments = {cls::tests::cls_binary()};
    arguments.insert(arguments.end(), command.begin(), command.end());
    const auto bad = cls::tests::run(arguments);
    EXPECT_EQ(bad.exit_code, 65);
    EXPECT_EQ(bad.err, "cls: " + script + ":2: /ruls: unknown key 'ruls'; did you mean 'rules'?\n");
  }
  const auto missing = cls::tests::run({cls::tests::cls_binary(), "mock", "nowhere.json"});
  EXPECT_EQ(missing.exit_code, 66);
  EXPECT_EQ(missing.err, "cls: nowhere.json: no such file\n");
  const auto rpc =
      cls::tests::run({cls::tests::cls_binary(), "mock", "--unimplemented", "Regster"});
  EXPECT_EQ(rpc.exit_code, 2);
  EXPECT_EQ(rpc.err, "cls: --unimplemented: unknown RPC 'Regster'; did you mean 'Register'?\n");
}

}  // namespace
