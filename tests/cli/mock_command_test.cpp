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
#include "tests/support/command_matchers.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

TEST(MockCommand, ServesMatchOnFreePortUntilSignal) {
  Command mock({cls_binary(), "mock"});
  ASSERT_TRUE(mock.wait_for_output("\n"));
  const std::string line = mock.out();
  ASSERT_EQ(line.rfind("listening on 127.0.0.1:", 0), 0u) << line;
  const std::string address = line.substr(13, line.find('\n') - 13);

  TemporaryFolder folder;
  EXPECT_THAT(run({cls_binary(), "match", address, "mock:hold", "--cycles", "50", "--set",
                   "server::kick_off_wait=3", "--dir", folder.path()}),
              Exits(0));
  mock.send_signal(SIGTERM);
  EXPECT_EQ(mock.finish().exit_code, 143);
}

TEST(MockCommand, ListensOnAddressesOfVersionSix) {
  if (std::ifstream("/proc/net/if_inet6").peek() == EOF) GTEST_SKIP() << "no IPv6 here";
  for (const char* host : {"::1", "[::1]"}) {
    Command mock({cls_binary(), "mock", "--host", host, "--port", "0"});
    EXPECT_TRUE(mock.wait_for_output("listening on ")) << mock.finish().err;
    mock.send_signal(SIGINT);
    mock.finish();
  }
}

TEST(MockCommand, RejectsFaultsOfUnknownPlayers) {
  const auto mock = [](const std::vector<std::string>& flags) {
    return run(joined({cls_binary(), "mock"}, flags));
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
  const auto unknown = run({cls_binary(), "mock", "hodl"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.err, "cls: unknown mock behavior 'hodl'; did you mean 'hold'?\n");

  Command mock({cls_binary(), "mock"});
  ASSERT_TRUE(mock.wait_for_output("\n"));
  const std::string line = mock.out();
  const std::string port = line.substr(line.rfind(':') + 1, line.find('\n') - line.rfind(':') - 1);
  const auto taken = run({cls_binary(), "mock", "--port", port});
  EXPECT_EQ(taken.exit_code, 75);
  EXPECT_THAT(taken.err, HasSubstr("TCP port " + port + " is taken by cls"));
}

// Plays cycles of the Playmaker at `address` against a mock that holds.
CommandResult play_at(const std::string& address, const std::vector<std::string>& more = {},
                      const std::string& cycles = "30") {
  TemporaryFolder folder;
  return run(joined({cls_binary(), "match", address, "mock:hold", "--cycles", cycles, "--set",
                     "server::kick_off_wait=3", "--dir", folder.path(), "--rpc-deadline", "300"},
                    more));
}

std::string address_of(const Command& mock) {
  const std::string line = mock.out();
  return line.substr(13, line.find('\n') - 13);
}

// Plays 30 cycles of `mock` (started with these flags) against a mock that holds.
CommandResult play_against(std::vector<std::string> flags,
                           const std::vector<std::string>& more = {}) {
  flags.insert(flags.begin(), {cls_binary(), "mock"});
  Command mock(flags);
  EXPECT_TRUE(mock.wait_for_output("\n"));
  return play_at(address_of(mock), more);
}

TEST(MockCommand, MatchReportsProcessFaults) {
  EXPECT_THAT(play_against({"--crash-at-cycle", "10"}), Exits(1, HasSubstr("no usable reply")));
  EXPECT_THAT(play_against({"--error", "1", "--status", "DATA_LOSS"}),
              Exits(1, HasSubstr("injected error")));
  EXPECT_THAT(play_against({"--drop", "0.02", "--fault-unum", "4"}), Exits(0));
}

// Replies to agents that do not register again are tested in tests/mock-server.
TEST(MockCommand, ListensAgainAfterRestart) {
  Command mock({cls_binary(), "mock", "--restart-at-cycle", "10", "--restart-after", "0"});
  ASSERT_TRUE(mock.wait_for_output("\n"));
  EXPECT_THAT(play_at(address_of(mock), {"--max-missed", "1000"}),
              Exits(0, HasSubstr("connection to the Playmaker lost")));
  EXPECT_THAT(play_at(address_of(mock), {}, "5"), Exits(0));
}

// A listener of gRPC that once found no free descriptor never accepts again.
TEST(MockCommand, AcceptsMatchesAfterMoreConnectionsThanItsSoftLimit) {
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  if (limit.rlim_max < 1000) GTEST_SKIP() << "needs 1000 descriptors, " << limit.rlim_max;
  rlimit low = limit;
  low.rlim_cur = 64;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &low), 0);

  Command mock({cls_binary(), "mock"});
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
    EXPECT_THAT(play_at(address, {}, "5"), Exits(0));
  }
  EXPECT_THAT(play_at(address, {}, "5"), Exits(0));
}

TEST(MockCommand, ReportsFailedExpectationsOfScript) {
  TemporaryFolder folder;
  const std::string script = folder.path() / "script.json";
  std::ofstream(script) << "{\"expect\": [{\"rpc\": \"Register\", \"count\": 13}]}";
  TemporaryFolder match;
  EXPECT_THAT(run({cls_binary(), "match", "mock:" + script, "mock:hold", "--cycles", "5", "--set",
                   "server::kick_off_wait=3", "--dir", match.path()}),
              Exits(0, HasSubstr("script: expected (line 1): 12 calls of Register, not == 13")));
}

TEST(MockCommand, SaysWhyItCannotListenAtHost) {
  for (const auto& [host, why] : {std::pair("bad host", "cannot be resolved: "),
                                  std::pair("192.0.2.1", "not an address of this host; ")}) {
    const auto refused = run({cls_binary(), "mock", "--host", host});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.err.find(std::string("cls: --host '") + host + "': " + why), 0u)
        << refused.err;
  }
}

TEST(MockCommand, ReportsInvalidAndMissingScripts) {
  TemporaryFolder folder;
  const std::string script = folder.path() / "script.json";
  std::ofstream(script) << "{\n  \"ruls\": []\n}";
  for (const auto& command : {std::vector<std::string>{"mock", script},
                              std::vector<std::string>{"match", "mock:" + script, "mock"}}) {
    EXPECT_THAT(
        run(joined({cls_binary()}, command)),
        Exits(65, "cls: " + script + ":2: /ruls: unknown key 'ruls'; did you mean 'rules'?\n"));
  }
  EXPECT_THAT(run({cls_binary(), "mock", "nowhere.json"}),
              Exits(66, "cls: nowhere.json: no such file\n"));
  EXPECT_THAT(run({cls_binary(), "mock", "--unimplemented", "Regster"}),
              Exits(2, "cls: --unimplemented: unknown RPC 'Regster'; did you mean 'Register'?\n"));
}

}  // namespace
}  // namespace cls::tests
