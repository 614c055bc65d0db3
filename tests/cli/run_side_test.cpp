// `run:` sides: Playmakers started by cls, working and with each kind of fault.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/marked_processes.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;
using json = base::Json;
using Arguments = std::vector<std::string>;

/// A match of the mock (left) against a fake Playmaker started by cls (right), in a temporary
/// folder and with a process mark.
class RunSide : public testing::Test {
 protected:
  static std::string fake(const std::string& flags) {
    return "run:exec " + built("cls_fake_playmaker") + " --port {port} " + flags;
  }

  Arguments arguments(const std::string& right, const Arguments& more) const {
    const Arguments argv =
        joined({cls_binary(), "match", "mock", right, "--seed", "7", "--right-name", "brain",
                "--set", "server::kick_off_wait=3", "--dir", folder_.path(), "--cycles", "60"},
               more);
    return argv;
  }
  Arguments environment() const { return {std::string(kMarkVariable) + "=" + mark_}; }

  /// Plays; no process may survive the return of cls.
  void play(const std::string& flags, const Arguments& more = {}) {
    played_ = run(arguments(fake(flags), more), environment());
    EXPECT_TRUE(all_marked_gone(mark_));
    result_ = json::parse(read_file(folder_.path() / "result.json"));
  }

  void expect_end(const std::string& reason, int exit_code, const std::string& message) const {
    EXPECT_EQ(result_["end_reason"], reason);
    EXPECT_EQ(played_.exit_code, exit_code);
    const std::string whole = result_["message"].get<std::string>();
    EXPECT_THAT(whole, HasSubstr(message));
    EXPECT_THAT(played_.err, HasSubstr("cls: " + whole + "\n"));
    EXPECT_TRUE(result_["winner"].is_null());
  }

  /// Result and stderr report the failed process with its last output lines.
  void expect_last_words(const std::string& argv, const std::string& exit) const {
    const json& failure = result_["failure"];
    EXPECT_EQ(failure["process"], "right Playmaker");
    EXPECT_EQ(failure["exit"], exit);
    EXPECT_EQ(failure["output"].back().get<std::string>().find(argv), 0U) << failure;
    EXPECT_THAT(played_.err, HasSubstr(argv));
    EXPECT_THAT(log(), HasSubstr(argv));
  }

  /// Waits until the Playmaker has printed `text`.
  bool wait_for_log(const std::string& text) const {
    const auto begin = std::chrono::steady_clock::now();
    const auto has_printed = [&] {
      return std::filesystem::exists(folder_.path() / "right-playmaker.log") &&
             log().find(text) != std::string::npos;
    };
    while (!has_printed() && std::chrono::steady_clock::now() - begin < 20s) {
      std::this_thread::sleep_for(20ms);
    }
    return has_printed();
  }
  std::string log() const { return read_file(folder_.path() / "right-playmaker.log"); }

  TemporaryFolder folder_;
  const std::string mark_ = new_mark();
  CommandResult played_;
  json result_;
};

TEST_F(RunSide, PlaysAndReportsCpuTime) {
  play("");
  EXPECT_EQ(played_.exit_code, 0) << played_.err;
  EXPECT_EQ(played_.err, "");
  EXPECT_EQ(result_["end_reason"], "finished");
  EXPECT_EQ(result_["cycles"], 60);
  ASSERT_EQ(result_["processes"].size(), 1U);
  const json& process = result_["processes"][0];
  EXPECT_EQ(process["name"], "right Playmaker");
  EXPECT_EQ(process["exit"], "ended by cls (killed by SIGTERM)");
  EXPECT_GT(process["cpu_seconds"].get<double>(), 0.01);
  EXPECT_GT(result_["right"]["cpu_seconds"], process["cpu_seconds"]);
  EXPECT_TRUE(result_["failure"].is_null());
}

TEST_F(RunSide, AcceptsSlowStart) {
  play("--late-start-ms 1500");
  EXPECT_EQ(played_.exit_code, 0) << played_.err;
}

TEST_F(RunSide, RefusesUnstartableProgram) {
  EXPECT_THAT(
      run(arguments("run:no-such-playmaker --port {port}", {}), environment()),
      Exits(69, testing::AllOf(HasSubstr("its process ended before it answered: exit code 127"),
                               HasSubstr("no-such-playmaker: not found"))));
}

TEST_F(RunSide, RefusesImmediatelyAfterExitAtStart) {
  const auto begin = std::chrono::steady_clock::now();
  play("--exit-at-start 5");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
  expect_end("refused", 69, "its process ended before it answered: exit code 5");
  expect_last_words("cannot load the formation", "exit code 5");
}

// Of six lines the last five are printed.
TEST_F(RunSide, ShowsNoMarkBelowALineThatItDoesNotShow) {
  const CommandResult played = run(
      arguments(
          "run:printf 'import team\n    ^^^^\nFile 11\n  a = b)\n       ^\nNo\n' {port}; exit 1",
          {}),
      environment());
  EXPECT_THAT(played.err, testing::Not(HasSubstr("Playmaker:     ^^^^")));
  EXPECT_THAT(played.err, HasSubstr("File 11"));
  EXPECT_THAT(played.err, HasSubstr("Playmaker:        ^"));
}

TEST_F(RunSide, NamesTheLimitThatEndedTheProgram) {
  const auto busy =
      run(arguments("run:while :; do :; done # {port}", {"--max-cpu", "1"}), environment());
  EXPECT_EQ(busy.exit_code, 69);
  EXPECT_THAT(busy.err,
              HasSubstr(": its process ended before it answered: killed by SIGXCPU; a process of "
                        "right Playmaker had used the 1 s of CPU time that --max-cpu allows: "
                        "raise or omit the limit"));

  std::filesystem::remove_all(folder_.path());
  const auto large =
      run(arguments("run:dd if=/dev/zero of=/dev/null bs=64M count=1; exit 3 # {port}",
                    {"--max-memory", "32M"}),
          environment());

  EXPECT_EQ(large.exit_code, 69);
  EXPECT_THAT(large.err,
              HasSubstr("exit code 3; a process of right Playmaker needed more than the 32M of "
                        "memory that --max-memory allows: raise or omit the limit"));
}

TEST_F(RunSide, PlaysWithinItsLimits) {
  play("", {"--max-memory", "1000T", "--max-cpu", "600"});
  EXPECT_EQ(played_.exit_code, 0) << played_.err;
  EXPECT_EQ(result_["processes"][0]["command"].get<std::string>().find(
                "(ulimit -d 1073741824000; ulimit -t 600; env "),
            0U);
}

TEST_F(RunSide, RefusesAtStartTimeoutWithoutListener) {
  play("--never-listen 1", {"--start-timeout", "1"});
  expect_end("refused", 69, "it did not listen on port ");
}

TEST_F(RunSide, ReportsDifferentPort) {
  play("--port-offset 1", {"--start-timeout", "1"});
  expect_end("refused", 69, "; it listens on port ");
}

TEST_F(RunSide, RefusesWithoutReply) {
  play("--silent 1", {"--start-timeout", "1"});
  expect_end("refused", 69, "within the start limit of 1 s");
}

TEST_F(RunSide, ReportsCrashAfterExit) {
  play("--exit-at-cycle 20");
  expect_end("crashed", 1, "its process ended at cycle ");
  expect_last_words("out of ideas", "exit code 3");
  EXPECT_GE(result_["cycles"], 19);
  EXPECT_LE(result_["cycles"], 22);
}

TEST_F(RunSide, ReportsCrashAfterExitZero) {
  play("--exit-at-cycle 20 --code 0");
  expect_end("crashed", 1, "exit code 0");
}

TEST_F(RunSide, ReportsSignalName) {
  play("--signal-at-cycle 20");
  expect_end("crashed", 1, "killed by SIGSEGV");
}

TEST_F(RunSide, ReportsSignalNameBelowShell) {
  const auto played = run(
      arguments("run:" + fake("--signal-at-cycle 20").substr(9) + "; exit $?", {}), environment());
  EXPECT_EQ(played.exit_code, 1);
  EXPECT_THAT(played.err, HasSubstr("exit code 139 (128 + SIGSEGV)"));
}

TEST_F(RunSide, StallsWhenProgramHangs) {
  play("--hang-at-cycle 20", {"--stall-after", "1"});
  expect_end("stalled", 1, "no new cycle for 1 s");
}

TEST_F(RunSide, EndsAsLateWithLateReplies) {
  play("--hang-at-cycle 20", {"--rpc-deadline", "30", "--max-missed", "5"});
  expect_end("late", 1, "no usable reply to 6 calls in a row");
}

TEST_F(RunSide, StopsHangingProgramAtTimeLimit) {
  play("--hang-at-cycle 20", {"--time-limit", "2", "--stall-after", "60"});
  expect_end("timed_out", 124, "the time limit of 2 s");
}

TEST_F(RunSide, ContinuesDespiteFloodOfOutput) {
  play("--flood 1");
  EXPECT_EQ(played_.exit_code, 0) << played_.err;
  EXPECT_LT(std::filesystem::file_size(folder_.path() / "right-playmaker.log"), 1000U);
  EXPECT_THAT(log(), HasSubstr("\n  ×"));
}

// The limit fails writes of cls as a full disk does.
TEST_F(RunSide, WarnsOfLogThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string match = folder.path() / "match";
  const CommandResult played =
      run({"/bin/sh", "-c",
           "ulimit -f 40; exec '" + cls_binary().string() + "' match 'run:seq 20000; exec \"" +
               cls_binary().string() + "\" mock hold --port {port}' mock:hold --cycles 5 --dir '" +
               match + "' --set server::game_logging=off --set server::text_logging=off"});
  EXPECT_THAT(played.err,
              HasSubstr("left-playmaker.log failed: File too large; the log is incomplete"));
}

TEST_F(RunSide, KillsProgramThatIgnoresSigterm) {
  play("--ignore-term 1");
  EXPECT_EQ(played_.exit_code, 0) << played_.err;
  EXPECT_EQ(result_["processes"][0]["exit"], "ended by cls (killed by SIGKILL)");
}

TEST_F(RunSide, KillsGrandchild) {
  play("--grandchild 1");
  EXPECT_EQ(played_.exit_code, 0) << played_.err;
}

TEST_F(RunSide, KillsGrandchildAfterCrash) {
  play("--grandchild 1 --exit-at-cycle 10");
  expect_end("crashed", 1, "exit code 3");
}

TEST_F(RunSide, StopsCleanlyAfterSignal) {
  const std::vector<std::pair<int, int>> cases = {{SIGINT, 130}, {SIGTERM, 143}};
  for (const auto& [signal, exit_code] : cases) {
    Arguments argv = arguments(fake("--ignore-term 1 --hang-at-cycle 30"), {});
    Command command(argv, environment());
    ASSERT_TRUE(wait_for_log("lost in thought"));
    command.send_signal(signal);
    const auto begin = std::chrono::steady_clock::now();
    const CommandResult ended = command.finish();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
    EXPECT_EQ(ended.exit_code, exit_code) << ended.err;
    const json result = json::parse(read_file(folder_.path() / "result.json"));
    EXPECT_EQ(result["end_reason"], "interrupted");
    EXPECT_TRUE(all_marked_gone(mark_));
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      std::filesystem::remove_all(entry.path());  // the next match wants an empty folder
    }
  }
}

TEST_F(RunSide, LeavesNoProcessAfterSigkill) {
  Command command(arguments(fake("--ignore-term 1 --grandchild 1 --hang-at-cycle 30"), {}),
                  environment());
  const auto begin = std::chrono::steady_clock::now();
  while (marked_processes(mark_).size() < 5 && std::chrono::steady_clock::now() - begin < 10s) {
    std::this_thread::sleep_for(20ms);
  }
  ASSERT_GE(marked_processes(mark_).size(), 5U);
  command.send_signal(SIGKILL);
  EXPECT_TRUE(all_marked_gone(mark_, 2s));
}

}  // namespace
}  // namespace cls::tests
