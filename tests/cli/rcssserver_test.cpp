// cls teams on rcssserver: from PATH or CLS_RCSSSERVER; skipped if not installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/marked_processes.h"
#include "tests/support/rcssserver.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// rcssserver with two teams of `cls proxy` and one `cls mock`.
class Rcssserver : public testing::Test {
 protected:
  void SetUp() override {
    if (rcssserver_program().empty()) GTEST_SKIP() << "no rcssserver on PATH nor in CLS_RCSSSERVER";
  }

  // Ports that the embedded server has just released are probably free.
  static int free_port() {
    const TemporaryFolder folder;
    Command probe({cls_binary(), "server", "--port", "0", "--dir", folder.path()});
    EXPECT_TRUE(probe.wait_for_output("\n"));
    const std::string line = probe.out();
    return std::stoi(line.substr(line.find(':') + 1));
  }

  std::unique_ptr<Command> start_server(const std::string& port,
                                        const std::vector<std::string>& settings) {
    const std::string path = folder_.path();
    return std::make_unique<Command>(
        joined({rcssserver_program(), "server::auto_mode=on", "server::kick_off_wait=5",
                "server::game_over_wait=5", "server::connect_wait=100000",
                "server::nr_extra_halfs=0", "server::penalty_shoot_outs=off",
                "server::port=" + port, "server::coach_port=" + std::to_string(free_port()),
                "server::olcoach_port=" + coach_port_, "server::game_logging=off",
                "server::text_logging=off"},
               settings),
        std::vector<std::string>{"RCSS_CONF_DIR=" + path + "/conf", "USER=nobody"}, path);
  }

  std::vector<std::string> team(const std::string& name, const std::string& port,
                                const std::string& rpc_port) const {
    return {cls_binary(), "proxy", "-h", "127.0.0.1",  "-p",     port,         "-P",
            coach_port_,  "-t",    name, "--rpc-port", rpc_port, "--rpc-host", "127.0.0.1"};
  }

  TemporaryFolder folder_;
  const std::string coach_port_ = std::to_string(free_port());
};

std::string rpc_port_of(Command& mock) {
  EXPECT_TRUE(mock.wait_for_output("\n"));
  const std::string line = mock.out();
  return line.substr(line.find(':') + 1, line.find('\n') - line.find(':') - 1);
}

TEST_F(Rcssserver, PlaysInSynchronousModeWithoutAMissedCycle) {
  const std::string port = std::to_string(free_port());
  Command mock({cls_binary(), "mock"});
  const std::string rpc_port = rpc_port_of(mock);
  const auto server = start_server(port, {"server::synch_mode=on", "server::half_time=10"});
  Command left(team("Reds", port, rpc_port));
  ASSERT_TRUE(left.wait_for_output("on the left in synchronous mode, players 1 to 11"));

  Command right(team("Blues", port, rpc_port));
  const auto served = server->finish();
  EXPECT_EQ(served.exit_code, 0) << served.err;
  EXPECT_THAT(served.err, Not(HasSubstr("missed a cycle")));
  EXPECT_THAT(served.out, HasSubstr("'Reds' vs 'Blues'"));

  for (Command* each : {&left, &right}) {
    const auto played = each->finish();
    EXPECT_EQ(played.exit_code, 0) << played.err;
    EXPECT_EQ(played.err, "");
    EXPECT_THAT(played.out, HasSubstr(" at cycle 200;"));
    EXPECT_THAT(played.out, HasSubstr(" 0 missed, 0 undecided cycles, 0 late commands"));
  }
}

TEST_F(Rcssserver, IsStartedAndStoppedByMatch) {
  const std::string mark = new_mark();
  const std::string folder = folder_.path() / "match";
  EXPECT_THAT(run({cls_binary(), "match", "mock", "mock", "--server", rcssserver_program(),
                   "--half-time", "10", "--dir", folder, "--set", "server::kick_off_wait=5"},
                  {std::string(kMarkVariable) + "=" + mark, "USER=root"}),
              Exits(0, ""));
  EXPECT_TRUE(marked_processes(mark).empty());

  const auto result = base::Json::parse(read_file(folder + "/result.json"));
  EXPECT_EQ(result["end_reason"], "finished");
  EXPECT_EQ(result["cycles"], 200);
  EXPECT_FALSE(result["server"]["version"].get<std::string>().empty());
  EXPECT_EQ(result["server"]["missed_cycles"], 0);
  EXPECT_GT(result["server"]["seed"], 0);
  EXPECT_EQ(result["processes"][0]["exit"], "exit code 0");

  // The server prints its random seed in a separate line.
  const std::string log = read_file(folder + "/server.log");
  EXPECT_THAT(log, HasSubstr("Simulator Random Seed: " + result["server"]["seed"].dump()));
  EXPECT_THAT(log, HasSubstr(folder + "/server-conf/server.conf"));
}

// By default it reads ~/.rcssserver and renames old configuration files there.
TEST_F(Rcssserver, IgnoresUserConfiguration) {
  const std::filesystem::path home = folder_.path() / "home";
  std::filesystem::create_directories(home / ".rcssserver");
  const std::string mine = "server::half_time = 1\n";
  std::ofstream(home / ".rcssserver/server.conf") << mine;
  std::ofstream(home / ".rcssserver-server.conf") << mine;
  EXPECT_THAT(
      run({cls_binary(), "match", "mock", "mock", "--server", rcssserver_program(), "--half-time",
           "2", "--dir", folder_.path() / "match", "--set", "server::kick_off_wait=5"},
          {"HOME=" + home.string(), "USER=root", "USERNAME=root"}),
      Exits(0));

  const auto result = base::Json::parse(read_file(folder_.path() / "match/result.json"));
  EXPECT_EQ(result["cycles"], 40);

  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(home)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    EXPECT_EQ(read_file(entry.path()), mine) << entry.path();
  }
  EXPECT_EQ(files, 2U);
}

TEST_F(Rcssserver, IsStartedByMatchInRealTime) {
  const std::string folder = folder_.path() / "match";
  EXPECT_THAT(
      run({cls_binary(), "match", "mock", "mock", "--server", rcssserver_program(), "--mode",
           "realtime", "--half-time", "2", "--dir", folder, "--set", "server::kick_off_wait=5"}),
      Exits(0));
  const auto result = base::Json::parse(read_file(folder + "/result.json"));
  EXPECT_EQ(result["cycles"], 40);
  EXPECT_EQ(result["mode"], "realtime");
}

// On a loaded host some cycles are missed; they must be few.
TEST_F(Rcssserver, PlaysInRealTime) {
  const std::string port = std::to_string(free_port());
  Command mock({cls_binary(), "mock"});
  const std::string rpc_port = rpc_port_of(mock);
  const auto server = start_server(port, {"server::synch_mode=off", "server::half_time=2"});
  Command left(team("Reds", port, rpc_port));
  ASSERT_TRUE(left.wait_for_output("on the left in real time, players 1 to 11"));

  Command right(team("Blues", port, rpc_port));
  EXPECT_THAT(server->finish(), Exits(0));

  for (Command* each : {&left, &right}) {
    const auto played = each->finish();
    EXPECT_EQ(played.exit_code, 0) << played.err;
    EXPECT_EQ(played.err, "");
    const std::size_t at = played.out.find("cycle 40; ");
    ASSERT_NE(at, std::string::npos) << played.out;
    // 11 players, 40 cycles of play.
    EXPECT_GT(std::stoi(played.out.substr(at + 10)), 11 * 36) << played.out;
  }
}

}  // namespace
}  // namespace cls::tests
