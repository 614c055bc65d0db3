// `cls server`, two teams of `cls proxy` and `cls mock`, each a separate process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/rcssserver.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

// Ignore the user's ~/.rcssserver.
const int kNoUserConfiguration = setenv("RCSS_CONF_DIR", "/nonexistent", 1);

/// The port in "listening on HOST:PORT...".
std::string port_in(Command& command) {
  EXPECT_TRUE(command.wait_for_output("\n"));
  const std::string line = command.out();
  const std::size_t colon = line.find(':');
  return line.substr(colon + 1, line.find_first_not_of("0123456789", colon + 1) - colon - 1);
}

// Where each agent has a machine of its own, nothing orders their starts.
TEST(ServerCommand, CoachWaitsForTheFirstPlayerOfItsTeam) {
  const TemporaryFolder folder;
  Command server({cls_binary(), "server", "--port", "0", "--seed", "7", "--dir", folder.path(),
                  "server::synch_mode=on"});
  const std::string port = port_in(server);
  const std::string ports = server.out();
  const std::string coaches = ports.substr(ports.find("coaches ") + 8);
  Command mock({cls_binary(), "mock"});
  const std::vector<std::string> proxy = {
      cls_binary(), "proxy",       "-h", "127.0.0.1", "-p", port,
      "--rpc-port", port_in(mock), "-t", "Reds",      "-P", coaches.substr(0, coaches.find('\n'))};
  const auto agent = [&proxy](std::vector<std::string> more) {
    more.insert(more.begin(), proxy.begin(), proxy.end());
    return more;
  };
  Command coach(agent({"--coach"}));

  EXPECT_FALSE(coach.wait_for_output("plays on", std::chrono::seconds(1)));

  Command player(agent({"--unum", "1"}));
  EXPECT_TRUE(coach.wait_for_output("Reds plays on the left")) << coach.out();
}

TEST(ServerCommand, ServesTwoProxyTeams) {
  TemporaryFolder folder;
  Command server({cls_binary(), "server", "--port", "0", "--seed", "7", "--cycles", "100", "--dir",
                  folder.path(), "server::kick_off_wait=3", "server::auto_mode=on",
                  "server::synch_mode=on"});
  const std::string port = port_in(server);
  Command mock({cls_binary(), "mock"});
  const std::string rpc_port = port_in(mock);
  const std::vector<std::string> proxy = {cls_binary(), "proxy",    "-h",         "127.0.0.1",
                                          "-p",         port,       "--rpc-port", rpc_port,
                                          "--rpc-host", "127.0.0.1"};
  const auto side = [&proxy](const char* name) {
    auto argv = proxy;
    argv.insert(argv.end(), {"-t", name, "--rpc-type", "grpc", "-P", "6002"});
    return argv;
  };
  Command left(side("Reds"));
  const std::string result = folder.path() / "blues.json";
  auto blues = side("Blues");
  blues.insert(blues.end(), {"--playmaker", "127.0.0.1:" + rpc_port, "--on-late", "last", "--batch",
                             "always", "--rpc-deadline", "2900", "--result", result});
  Command right(blues);
  const auto served = server.finish();

  EXPECT_EQ(served.exit_code, 0) << served.err;
  EXPECT_THAT(served.out, HasSubstr("\n100 cycles, 0 of them missed"));
  EXPECT_THAT(served.out, HasSubstr("Simulator Random Seed: 7\n"));
  EXPECT_THAT(served.out, HasSubstr("A new (v19) player (Reds 1) connected.\n"));
  EXPECT_THAT(served.out, HasSubstr("A new (v19) player (Blues 11) connected.\n"));
  EXPECT_THAT(served.out, HasSubstr("Game Over. Exiting...\n"));

  for (const char* line :
       {"\nWaiting for players to connect\n", "\nWaiting to kick off\n", "\nKick_off_left\n"}) {
    EXPECT_THAT(served.out, HasSubstr(line)) << line;
  }

  for (Command* team : {&left, &right}) {
    const auto played = team->finish();
    EXPECT_EQ(played.exit_code, 0) << played.err;
    EXPECT_THAT(played.err, Not(HasSubstr("stopped responding")));
    EXPECT_THAT(played.out, HasSubstr(" at cycle 100; "));
    EXPECT_THAT(played.out, HasSubstr(" 0 missed, 0 undecided cycles, 0 late commands"))
        << played.err;
  }

  const auto document = base::Json::parse(read_file(result));
  EXPECT_EQ(document["schema"], "cls.proxy/1");
  EXPECT_EQ(document["end_reason"], "finished");
  ASSERT_EQ(document["players"].size(), 11U);

  for (const auto& player : document["players"]) {
    EXPECT_GE(player["decisions"], 100);
    EXPECT_EQ(player["missed"], 0);
    EXPECT_GT(player["rpc_us"]["p50"], 0);
  }

  const std::string log = read_file(std::filesystem::path(folder.path()) / "match.rcg");
  EXPECT_THAT(log, HasSubstr("Reds"));
  EXPECT_THAT(log, HasSubstr("Blues"));
}

TEST(ServerCommand, ProxyRefusesPlaymakerWithoutRequiredTeamService) {
  TemporaryFolder folder;
  Command server({cls_binary(), "server", "--port", "0", "--dir", folder.path()});
  const std::string port = port_in(server);
  Command older({cls_binary(), "mock", "--unimplemented", "GetBestPlannerAction"});
  const std::string rpc_port = port_in(older);
  EXPECT_THAT(run({cls_binary(), "proxy", "-p", port, "--rpc-port", rpc_port, "-h", "127.0.0.1",
                   "-C", "--batch", "always"}),
              Exits(69, HasSubstr("does not implement TeamPlaymaker")));
  EXPECT_EQ(run({cls_binary(), "proxy", "--rpc-port-step", "--batch", "always"}).exit_code, 2);
}

CommandResult end_server_by(int signal) {
  TemporaryFolder folder;
  Command server({cls_binary(), "server", "--port", "0", "--dir", folder.path()});
  port_in(server);
  server.send_signal(signal);
  return server.finish();
}

TEST(ServerCommand, ListensOnNamesAndBracketsOfThisHost) {
  for (const char* host : {"localhost", "[::1]", "::1"}) {
    const TemporaryFolder folder;
    if (std::ifstream("/proc/net/if_inet6").peek() == EOF && host[0] != 'l') continue;
    Command server(
        {cls_binary(), "server", "--host", host, "--port", "0", "--dir", folder.path().string()});
    EXPECT_TRUE(server.wait_for_output("listening on ")) << server.finish().err;
    server.send_signal(SIGINT);
    server.finish();
  }
}

TEST(ServerCommand, PrintsResultAfterSignal) {
  EXPECT_THAT(end_server_by(SIGTERM),
              Prints(143, testing::AllOf(HasSubstr("\nServer Killed. Exiting...\n"),
                                         HasSubstr("\tnull vs null\n\tScore: 0 - 0\n"),
                                         HasSubstr("; step lateness: mean "))));
}

TEST(ServerCommand, StopsCleanlyOnSighup) {
  EXPECT_THAT(end_server_by(SIGHUP), Prints(130, HasSubstr("\nServer Killed. Exiting...\n")));
}

TEST(ServerCommand, SendsRequestedPorts) {
  const int port = free_udp_port();
  TemporaryFolder folder;
  Command server({cls_binary(), "server", "--port", std::to_string(port), "--dir", folder.path()});
  EXPECT_EQ(port_in(server), std::to_string(port));
  server.send_signal(SIGINT);
  EXPECT_EQ(server.finish().exit_code, 130);
  const std::string log = read_file(folder.path() / "match.rcg");
  for (const std::string& document :
       {"(port " + std::to_string(port) + ')', "(coach_port " + std::to_string(port + 1) + ')',
        "(olcoach_port " + std::to_string(port + 2) + ')'}) {
    EXPECT_THAT(log, HasSubstr(document)) << document;
  }
}

TEST(ServerCommand, RejectsUnsupportedSettings) {
  const std::pair<const char*, const char*> wishes[] = {
      {"server::game_log_version=7", "game_log_version=7: must be 1 to 6, or -1 (JSON)"},
      {"server::no_such=1", "no_such"},
      {"server::half_time", "server::NAME=VALUE"},
      {"--prot", "unknown option '--prot'; did you mean '--port'?"},
      {"server::half_time=-x", "'-x' is not a whole number"},
  };
  for (const auto& [setting, reason] : wishes) {
    const auto refused = run({cls_binary(), "server", "--port", "0", setting});
    EXPECT_EQ(refused.exit_code, 2) << setting;
    EXPECT_THAT(refused.err, HasSubstr(reason));
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
  }
}

TEST(ServerCommand, AcceptsSpacesAndQuotesAsRcssserver) {
  TemporaryFolder folder;
  Command server({cls_binary(), "server", "--port", "0", "--dir", folder.path(),
                  "server::game_log_fixed_name='match'", "server::landmark_file=", "'a b.xml'",
                  "server::half_time", "=", "10"});
  port_in(server);
  server.send_signal(SIGINT);
  EXPECT_THAT(server.finish(), Exits(130));
}

TEST(ServerCommand, WritesLogsAndCsvToRcssserverPaths) {
  TemporaryFolder folder;
  const std::filesystem::path here = folder.path();
  std::ofstream(here / "server.conf") << "server::game_log_dir = '" << here.string() << "'\n"
                                      << "server::text_logging = off\n"
                                      << "server::game_log_dated = off\n";
  setenv("RCSS_CONF_DIR", folder.path().c_str(), 1);
  Command server({cls_binary(), "server", "--server::port=0", "server::coach_port=0",
                  "server::olcoach_port=0", "CSVSaver::save=on",
                  "CSVSaver::filename=" + (here / "table.csv").string()});

  setenv("RCSS_CONF_DIR", "/nonexistent", 1);
  ASSERT_TRUE(server.wait_for_output("listening on "));

  server.send_signal(SIGTERM);
  const auto served = server.finish();
  EXPECT_EQ(served.exit_code, 143) << served.err;
  EXPECT_TRUE(std::filesystem::exists(here / "null-vs-null.rcg")) << served.out;
  EXPECT_THAT(read_file(here / "table.csv"), HasSubstr(", NULL, NULL, NULL, NULL, 0, 0, "));
  EXPECT_THAT(served.out, HasSubstr("configuration: " + (here / "server.conf").string()));
}

TEST(ServerCommand, ReportsErrorsInConfigurationFile) {
  TemporaryFolder folder;
  const std::filesystem::path here = folder.path();
  std::ofstream(here / "server.conf") << "\nserver::half_tim = 3\n";
  setenv("RCSS_CONF_DIR", folder.path().c_str(), 1);
  const auto refused = run({cls_binary(), "server", "--port", "0"});
  setenv("RCSS_CONF_DIR", "/nonexistent", 1);
  EXPECT_EQ(refused.exit_code, 78);
  EXPECT_EQ(refused.err, "cls: " + (here / "server.conf").string() +
                             ":2: unknown parameter 'half_tim'; did you mean 'half_time'?\n");
}

TEST(ServerCommand, ReportsPortInUse) {
  TemporaryFolder folder;
  Command server({cls_binary(), "server", "--port", "0", "--dir", folder.path()});
  const std::string port = port_in(server);
  const auto taken = run({cls_binary(), "server", "--port", port, "--dir", folder.path()});
  EXPECT_EQ(taken.exit_code, 75);
  EXPECT_THAT(taken.err, HasSubstr("UDP port " + port + " is taken by"));
}

TEST(ProxyCommand, ReportsUnreachableServer) {
  std::string port;
  {
    TemporaryFolder folder;
    Command server({cls_binary(), "server", "--port", "0", "--dir", folder.path()});
    port = port_in(server);
  }
  EXPECT_THAT(run({cls_binary(), "proxy", "-p", port, "--start-timeout", "0.5"}),
              Exits(69, HasSubstr("no soccer server answers at localhost:" + port)));
}

TEST(ProxyCommand, ReportsUnreachablePlaymaker) {
  TemporaryFolder folder;
  Command server({cls_binary(), "server", "--port", "0", "--dir", folder.path()});
  const std::string port = port_in(server);
  EXPECT_THAT(run({cls_binary(), "proxy", "-p", port, "-t", "Reds", "--rpc-port", "1",
                   "--start-timeout", "1"}),
              Exits(69, HasSubstr("localhost:1")));
}

TEST(ProxyCommand, AcceptsOptionsOfUpstreamStartScript) {
  Command proxy({cls_binary(),
                 "proxy",
                 "-h",
                 "127.0.0.1",
                 "-p",
                 "9",
                 "-P",
                 "9",
                 "-t",
                 "Reds",
                 "-n",
                 "11",
                 "-C",
                 "--rpc-host",
                 "127.0.0.1",
                 "--rpc-port",
                 "9",
                 "--rpc-port-step",
                 "--rpc-add-20-to-port-for-right",
                 "--rpc-type",
                 "grpc",
                 "--rpc-timeout",
                 "6",
                 "--fullstate",
                 "ignore",
                 "--offline-logging",
                 "--debug",
                 "--debug-start-time",
                 "1",
                 "--debug-end-time",
                 "2",
                 "--debug-server-connect",
                 "--debug-server-host",
                 "localhost",
                 "--debug-server-port",
                 "6032",
                 "--debug-server-logging",
                 "--log-dir",
                 "/tmp",
                 "--debug-log-ext",
                 ".log",
                 "--start-timeout",
                 "0.1"});
  const auto ended = proxy.finish();

  EXPECT_EQ(ended.exit_code, 69) << ended.err;

  // The reason, and where to read on.
  EXPECT_EQ(std::ranges::count(ended.err, '\n'), 2) << ended.err;
}

TEST(ProxyCommand, ReportsUsageErrors) {
  EXPECT_EQ(run({cls_binary(), "proxy", "-t", "much_too_long_a_name"}).exit_code, 2);
  EXPECT_EQ(run({cls_binary(), "proxy", "-u", "12", "-C"}).exit_code, 2);
  EXPECT_EQ(run({cls_binary(), "proxy", "--rpc-prot", "1"}).exit_code, 2);
  EXPECT_THAT(run({cls_binary(), "proxy", "--formation", "no/such/folder"}),
              Exits(2, HasSubstr("no/such/folder: no such folder")));
  EXPECT_EQ(run({cls_binary(), "proxy", "--debug-log", "no/such/folder"}).exit_code, 2);
}

TEST(ProxyCommand, ReconnectsDisconnectedPlayer) {
  TemporaryFolder folder;
  Command server({cls_binary(), "server", "--port", "0", "--dir", folder.path(),
                  "server::connect_wait=100000", "server::synch_mode=on"});
  const std::string port = port_in(server);
  Command mock({cls_binary(), "mock"});
  const std::vector<std::string> argv = {cls_binary(), "proxy",      "-p",          port, "-t",
                                         "Reds",       "--rpc-port", port_in(mock), "-n", "2"};
  Command first(argv);
  ASSERT_TRUE(
      first.wait_for_output("Reds plays on the left in synchronous mode, players 1 to 2\n"));

  first.send_signal(SIGTERM);
  const auto left = first.finish();
  EXPECT_EQ(left.exit_code, 143) << left.err;

  auto again = argv;
  again.insert(again.end(), {"--reconnect"});
  Command second(again);
  ASSERT_TRUE(
      second.wait_for_output("Reds plays on the left in synchronous mode, players 1 to 2\n"));
  second.send_signal(SIGINT);
  EXPECT_THAT(second.finish(), Exits(130));
}

}  // namespace
}  // namespace cls::tests
