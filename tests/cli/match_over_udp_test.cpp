// What works in matches over UDP as in lockstep: recordings, debug logs, stepping, speed, monitors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_client.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using testing::Not;
using Arguments = std::vector<std::string>;

class MatchOverUdp : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path() / name; }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  /// A script that runs the fake server, which speaks rcssserver's protocol.
  std::string fake_server() const {
    const std::string file =
        write("server", "#!/bin/sh\nexec " + built("cls_fake_server") + " \"$@\"\n");
    ::chmod(file.c_str(), 0755);
    return file;
  }
  Arguments match(const Arguments& more) const {
    const Arguments arguments =
        joined({cls_binary(), "match", "--seed", "7", "--set", "server::kick_off_wait=3", "--dir",
                path("match"), "--force"},
               more);
    return arguments;
  }
  /// Plays a match with `input` as standard input.
  CommandResult play_with_input(const std::string& input, const Arguments& more) const {
    std::string command = "printf '" + input + "' |";
    for (const std::string& argument : match(more)) command += " '" + argument + "'";
    return run({"/bin/sh", "-c", command});
  }
  std::string file(const std::string& name) const { return read_file(path("match/" + name)); }
  json result() const { return json::parse(file("result.json")); }

  TemporaryFolder folder_;
};

TEST_F(MatchOverUdp, RecordsRpcsThatReplayWithoutDifference) {
  for (const std::string& server : {std::string("embedded"), fake_server()}) {
    ASSERT_THAT(run(match({"mock", "mock:hold", "--server", server, "--mode", "synch", "--cycles",
                           "20", "--record-rpc", path("calls.rpc")})),
                Exits(0));
    for (const auto& [side, playmaker] : {std::pair("left", "mock"), {"right", "mock:hold"}}) {
      const CommandResult replayed = run({cls_binary(), "test", "--replay", path("calls.rpc"),
                                          playmaker, "--side", side, "--json"});
      EXPECT_EQ(replayed.exit_code, 0) << replayed.out << replayed.err;
      const json report = json::parse(replayed.out);
      EXPECT_EQ(report["different"], 0) << replayed.out;
      EXPECT_GT(report["same"], 200) << replayed.out;
    }
  }
}

TEST_F(MatchOverUdp, RecordsRpcsInRealTime) {
  ASSERT_THAT(run(match({"mock", "mock", "--mode", "realtime", "--cycles", "10", "--record-rpc",
                         path("calls.rpc")})),
              Exits(0));
  EXPECT_THAT(run({cls_binary(), "test", "--replay", path("calls.rpc"), "mock"}), Exits(0));
}

TEST_F(MatchOverUdp, WritesDebugActionsByCycle) {
  const std::string script = write("talk.json", R"({"rules": [
    {"when": {"cycle": [5, 6], "unum": [3, 9]},
     "reply": [{"log": {"add_text": {"level": "TEAM", "message": "hello"}}}]}]})");
  ASSERT_THAT(
      run(match({"mock:hold", "mock:" + script, "--server", fake_server(), "--cycles", "12"})),
      Exits(0));
  EXPECT_EQ(file("right-debug.jsonl"),
            R"({"t":5,"unum":3,"kind":"text","level":"TEAM","message":"hello"}
{"t":5,"unum":9,"kind":"text","level":"TEAM","message":"hello"}
{"t":6,"unum":3,"kind":"text","level":"TEAM","message":"hello"}
{"t":6,"unum":9,"kind":"text","level":"TEAM","message":"hello"}
)");
}

TEST_F(MatchOverUdp, ReportsFailedExpectationsOfMockScripts) {
  const std::string script =
      write("demanding.json", R"({"expect": [{"rpc": "GetTrainerActions", "count": 1}]})");
  EXPECT_THAT(run(match({"mock:hold", "mock:" + script, "--mode", "synch", "--cycles", "5"})),
              Exits(0, HasSubstr("GetTrainerActions")));
}

TEST_F(MatchOverUdp, StepsThroughCyclesInSynchMode) {
  const CommandResult played = play_with_input(
      "\\n3\\nq\\n", {"mock:hold", "mock:hold", "--mode", "synch", "--at", "10", "--cycles", "30"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(played.err, HasSubstr("cycle 10 "));
  EXPECT_THAT(played.err, HasSubstr("cycle 11 "));
  EXPECT_THAT(played.err, Not(HasSubstr("cycle 12 ")));
  EXPECT_THAT(played.err, HasSubstr("cycle 14 "));
  EXPECT_THAT(played.err, Not(HasSubstr("cycle 15 ")));
  EXPECT_EQ(result()["end_reason"], "finished");
  EXPECT_LT(result()["cycles"], 17);
}

// The clock reaches the end of the half in a step that no log shows.
TEST_F(MatchOverUdp, EndsAtCycleLimitAtEndOfHalf) {
  EXPECT_THAT(run(match({"mock", "mock", "--mode", "synch", "--half-time", "5", "--cycles", "50"})),
              Exits(0));
  EXPECT_EQ(result()["cycles"], 50);
}

TEST_F(MatchOverUdp, ContinuesAfterEndOfInputWhenStepping) {
  const CommandResult played = play_with_input(
      "\\n", {"mock:hold", "mock:hold", "--mode", "synch", "--step", "--cycles", "10"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  // The first cycle that both sides know to be the same.
  EXPECT_TRUE(played.err.starts_with("cycle 0 kick_off_l ")) << played.err;
  EXPECT_EQ(result()["cycles"], 10);
}

TEST_F(MatchOverUdp, LimitsSpeedInSynchMode) {
  EXPECT_THAT(run(match({"mock:hold", "mock:hold", "--server", fake_server(), "--cycles", "20",
                         "--speed", "2"})),
              Exits(0));
  // Cycles of 100 ms at twice the speed: 20 a second.
  EXPECT_LT(result()["cycles_per_second"], 25.0);
}

TEST_F(MatchOverUdp, PrintsWhereMonitorsConnect) {
  // Free a moment ago.
  const int port = UdpClient(1).own_port();
  Command running(match({"mock:hold", "mock:hold", "--mode", "synch", "--speed", "5", "--cycles",
                         "30", "--monitor-port", std::to_string(port)}));
  UdpClient monitor(port);
  std::string message;
  for (int i = 0; i < 500 && message.empty(); ++i) {
    monitor.send("(dispinit version 5)");
    message = monitor.wait(std::chrono::milliseconds(20));
  }
  EXPECT_TRUE(message.starts_with("(server_param ")) << message;
  EXPECT_THAT(running.finish(),
              Exits(0, HasSubstr("monitors may attach at 127.0.0.1:" + std::to_string(port))));
}

TEST_F(MatchOverUdp, RejectsMonitorPortOfRunningServer) {
  EXPECT_THAT(
      run({cls_binary(), "match", "mock", "mock", "--server", "localhost:6000", "--monitor-port",
           "0"}),
      Exits(2, "cls: --monitor-port: monitors connect to the server at localhost:6000 itself\n"));
}

}  // namespace
}  // namespace cls::tests
