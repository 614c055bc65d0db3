// What works in matches over UDP as in lockstep: recordings, debug logs, stepping, speed, monitors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_client.h"

namespace {

using cls::tests::cls_binary;
using cls::tests::Command;
using cls::tests::CommandResult;
using nlohmann::json;
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
        write("server", "#!/bin/sh\nexec " + cls::tests::built("cls_fake_server") + " \"$@\"\n");
    ::chmod(file.c_str(), 0755);
    return file;
  }
  Arguments match(const Arguments& more) const {
    Arguments arguments = {cls_binary(), "match",       "--seed",
                           "7",          "--set",       "server::kick_off_wait=3",
                           "--dir",      path("match"), "--force"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  /// Plays a match with `input` as standard input.
  CommandResult play_with_input(const std::string& input, const Arguments& more) const {
    std::string command = "printf '" + input + "' |";
    for (const std::string& argument : match(more)) command += " '" + argument + "'";
    return cls::tests::run({"/bin/sh", "-c", command});
  }
  std::string file(const std::string& name) const {
    return cls::tests::read_file(path("match/" + name));
  }
  json result() const { return json::parse(file("result.json")); }

  cls::tests::TemporaryFolder folder_;
};

TEST_F(MatchOverUdp, RecordsRpcsThatReplayWithoutDifference) {
  for (const std::string& server : {std::string("embedded"), fake_server()}) {
    const CommandResult played =
        cls::tests::run(match({"mock", "mock:hold", "--server", server, "--mode", "synch",
                               "--cycles", "20", "--record-rpc", path("calls.rpc")}));
    ASSERT_EQ(played.exit_code, 0) << played.err;
    for (const auto& [side, playmaker] : {std::pair("left", "mock"), {"right", "mock:hold"}}) {
      const CommandResult replayed =
          cls::tests::run({cls_binary(), "test", "--replay", path("calls.rpc"), playmaker, "--side",
                           side, "--json"});
      EXPECT_EQ(replayed.exit_code, 0) << replayed.out << replayed.err;
      const json report = json::parse(replayed.out);
      EXPECT_EQ(report["different"], 0) << replayed.out;
      EXPECT_GT(report["same"], 200) << replayed.out;
    }
  }
}

TEST_F(MatchOverUdp, RecordsRpcsInRealTime) {
  const CommandResult played = cls::tests::run(match(
      {"mock", "mock", "--mode", "realtime", "--cycles", "10", "--record-rpc", path("calls.rpc")}));
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const CommandResult replayed =
      cls::tests::run({cls_binary(), "test", "--replay", path("calls.rpc"), "mock"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.out << replayed.err;
}

TEST_F(MatchOverUdp, WritesDebugActionsByCycle) {
  const std::string script = write("talk.json", R"({"rules": [
    {"when": {"cycle": [5, 6], "unum": [3, 9]},
     "reply": [{"log": {"add_text": {"level": "TEAM", "message": "hello"}}}]}]})");
  const CommandResult played = cls::tests::run(
      match({"mock:hold", "mock:" + script, "--server", fake_server(), "--cycles", "12"}));
  ASSERT_EQ(played.exit_code, 0) << played.err;
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
  const CommandResult played =
      cls::tests::run(match({"mock:hold", "mock:" + script, "--mode", "synch", "--cycles", "5"}));
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(played.err, HasSubstr("GetTrainerActions")) << played.err;
}

TEST_F(MatchOverUdp, StepsThroughCyclesInSynchMode) {
  const CommandResult played = play_with_input(
      "\\n3\\nq\\n", {"mock:hold", "mock:hold", "--mode", "synch", "--at", "10", "--cycles", "30"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(played.err, HasSubstr("cycle 10 ")) << played.err;
  EXPECT_THAT(played.err, HasSubstr("cycle 11 ")) << played.err;
  EXPECT_THAT(played.err, Not(HasSubstr("cycle 12 "))) << played.err;
  EXPECT_THAT(played.err, HasSubstr("cycle 14 ")) << played.err;
  EXPECT_THAT(played.err, Not(HasSubstr("cycle 15 "))) << played.err;
  EXPECT_EQ(result()["end_reason"], "finished");
  EXPECT_LT(result()["cycles"], 17);
}

// The clock reaches the end of the half in a step that no log shows.
TEST_F(MatchOverUdp, EndsAtCycleLimitAtEndOfHalf) {
  const CommandResult run = cls::tests::run(
      match({"mock", "mock", "--mode", "synch", "--half-time", "5", "--cycles", "50"}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
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
  const CommandResult played = cls::tests::run(match(
      {"mock:hold", "mock:hold", "--server", fake_server(), "--cycles", "20", "--speed", "2"}));
  EXPECT_EQ(played.exit_code, 0) << played.err;
  // Cycles of 100 ms at twice the speed: 20 a second.
  EXPECT_LT(result()["cycles_per_second"], 25.0);
}

TEST_F(MatchOverUdp, PrintsWhereMonitorsConnect) {
  // Free a moment ago.
  const int port = cls::tests::UdpClient(1).own_port();
  Command running(match({"mock:hold", "mock:hold", "--mode", "synch", "--speed", "5", "--cycles",
                         "30", "--monitor-port", std::to_string(port)}));
  cls::tests::UdpClient monitor(port);
  std::string message;
  for (int i = 0; i < 500 && message.empty(); ++i) {
    monitor.send("(dispinit version 5)");
    message = monitor.wait(std::chrono::milliseconds(20));
  }
  EXPECT_TRUE(message.starts_with("(server_param ")) << message;
  const CommandResult played = running.finish();
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(played.err, HasSubstr("monitors may attach at 127.0.0.1:" + std::to_string(port)))
      << played.err;
}

TEST_F(MatchOverUdp, RejectsMonitorPortOfRunningServer) {
  const CommandResult refused = cls::tests::run(
      {cls_binary(), "match", "mock", "mock", "--server", "localhost:6000", "--monitor-port", "0"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err,
            "cls: --monitor-port: monitors connect to the server at localhost:6000 itself\n");
}

}  // namespace
