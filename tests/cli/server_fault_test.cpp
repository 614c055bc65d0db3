// Matches on external servers with each kind of fault.
#include "tests/cli/network_match.h"

#include <gmock/gmock.h>

namespace cls::tests {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;
using ServerFault = NetworkMatch;

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
  play("mock", server("--port-offset 3"), {"--start-timeout", "1"});
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
  // Killed, it did not write the rest of its log.
  expect_end("server_failed", 1, "the result is unknown: match.rcg ends at cycle ");
  EXPECT_EQ(result_["cycles"], 9);
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
  EXPECT_THAT(played_.err, HasSubstr("the log says 7 : 8, but the players of hold counted "));
}

// Any program of the host can tell agents of cls a score in the name of the server.
TEST_F(ServerFault, CountsNoScoreThatOnlyPlayersHeard) {
  play("mock", script("server", then("rm match.rcg")), {"--half-time", "2"});
  expect_end("server_failed", 1, "the result is unknown: ");
  EXPECT_EQ(result_["cycles"], 40);
  EXPECT_TRUE(result_["log_files"]["rcg"].is_null());
  EXPECT_THAT(played_.err, HasSubstr("; the cls agents heard "));
}

// Who leads could tell agents of cls that the match is over.
TEST_F(ServerFault, CountsNoLogWithoutTheEndOfTheMatch) {
  play("mock", script("server", then("sed -i 's/ time_over)/ play_on)/' match.rcg")),
       {"--half-time", "2"});
  expect_end("server_failed", 1, "the result is unknown: match.rcg ends at cycle ");
}

TEST_F(ServerFault, FailsWithoutLogAndPlayers) {
  left_ = team("");
  play(left_, script("server", then("rm match.rcg")), {"--half-time", "1"});
  expect_end("server_failed", 1, "the result is unknown: ");
}

}  // namespace
}  // namespace cls::tests
