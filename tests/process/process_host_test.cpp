// Children: start, status, output, and termination with all descendants.
#include "process/process_host.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "process/guard.h"
#include "process/process_tree.h"
#include "tests/process/test_guard.h"
#include "tests/support/built.h"
#include "tests/support/files.h"
#include "tests/support/marked_processes.h"
#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

using namespace std::chrono_literals;
using Lines = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

// The output of a fake until its exit.
Lines output_of(std::vector<std::string> actions) {
  MarkedHost processes;
  const auto child = processes.start_fake(std::move(actions));
  EXPECT_TRUE(child->wait_gone(10s));
  return child->last_lines();
}

std::string error_of_start(const CommandPlan& plan) {
  MarkedHost processes;
  const auto child = processes.host.start(plan);
  return child ? "started" : child.error().message;
}

TEST(ProcessHost, SaysThatItHasNoDescriptors) {
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &limit), 0);

  const int next = ::dup(STDERR_FILENO);
  ::close(next);
  const rlimit none_free{static_cast<rlim_t>(next), limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none_free), 0);
  const auto host = ProcessHost::create();
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &limit), 0);
  ASSERT_FALSE(host);
  EXPECT_EQ(host.error().message, "cannot start processes: Too many open files");
}

// Keepers inherit the limit of the guard.
TEST(ProcessHost, StartsOrSaysWhyNotWithFewDescriptors) {
  MarkedHost processes;
  const pid_t guard = Guard::active()->pid();
  rlimit before{};
  ASSERT_EQ(::prlimit(guard, RLIMIT_NOFILE, nullptr, &before), 0);

  int failed = 0;
  for (rlim_t limit = 5; limit < 14; ++limit) {
    const rlimit low{limit, before.rlim_max};
    ASSERT_EQ(::prlimit(guard, RLIMIT_NOFILE, &low, nullptr), 0);
    const auto child = processes.host.start(shell_command("a shell", "exit 3"));
    failed += !child;
    if (child) {
      EXPECT_TRUE((*child)->wait_gone(10s)) << limit;
    }
  }

  ASSERT_EQ(::prlimit(guard, RLIMIT_NOFILE, &before, nullptr), 0);
  EXPECT_GT(failed, 0);
  EXPECT_LT(failed, 9);
}

TEST(ProcessHost, ReportsExitCodeAndLastOutputLines) {
  MarkedHost processes;
  const auto child = processes.start_fake({"print", "hello", "print-error", "oh", "exit", "3"});
  ASSERT_TRUE(child->wait_exit(10s));

  const Child::Status status = child->status();
  EXPECT_EQ(to_text(*status.exit), "exit code 3");
  EXPECT_EQ(status.living, 0);
  EXPECT_TRUE(has_ended(status));
  EXPECT_EQ(child->last_lines(), (Lines{"hello", "oh"}));
  EXPECT_TRUE(child->wait_gone(1s));
}

TEST(ProcessHost, ReportsSignalNames) {
  MarkedHost processes;
  for (const int number : {SIGSEGV, SIGABRT, SIGKILL, SIGTERM}) {
    const auto child = processes.start_fake({"signal", std::to_string(number)});
    ASSERT_TRUE(child->wait_exit(10s));
    EXPECT_EQ(to_text(*child->status().exit), "killed by " + signal_name(number));
  }
}

TEST(ProcessHost, ReportsWhyProgramCannotBeStarted) {
  const tests::TemporaryFolder folder;
  CommandPlan plan = fake({});
  plan.argv.front() = "no-such-program";
  EXPECT_EQ(error_of_start(plan),
            "cannot start the fake: no-such-program: no such program on PATH");

  const std::filesystem::path broken = folder.path() / "broken";
  std::ofstream(broken) << "#!/no/such/interpreter\n";
  ::chmod(broken.c_str(), 0755);
  plan.argv.front() = broken;
  EXPECT_EQ(error_of_start(plan),
            "cannot start the fake: " + broken.string() +
                " cannot be started: its interpreter /no/such/interpreter does not exist");

  plan = fake({});
  plan.folder = folder.path() / "none";
  EXPECT_EQ(error_of_start(plan),
            "cannot start the fake: " + plan.folder.string() + ": no such folder");

  plan = fake({});
  plan.log = folder.path() / "none" / "x.log";
  EXPECT_EQ(error_of_start(plan), "cannot start the fake: cannot create " + plan.log.string() +
                                      ": No such file or directory");
  plan = fake({std::string(300'000, 'x')});
  EXPECT_EQ(error_of_start(plan), "cannot start the fake: the command line is too long");
}

TEST(ProcessHost, RunsScriptsWithoutShebangLikeShells) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path script = folder.path() / "start";
  std::ofstream(script) << "echo \"$1 and $2\"\n";
  ::chmod(script.c_str(), 0755);
  MarkedHost processes;
  CommandPlan plan;
  plan.name = "script";
  plan.argv = {script, "one", "2 3"};
  const auto child = processes.start(plan);

  ASSERT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(child->last_lines(), Lines{"one and 2 3"});
}

TEST(ProcessHost, StartsChildrenWithDefaultSignalsAndNoExtraDescriptors) {
  EXPECT_EQ(output_of({"print-fds"}), Lines{"fds: 0 1 2"});
  EXPECT_EQ(output_of({"print-signals"}), Lines{"signals:"});
  EXPECT_EQ(output_of({"print-group"}), Lines{"leader"});
  EXPECT_EQ(output_of({"print-input"}), Lines{"no input"});
}

TEST(ProcessHost, PassesArgumentsFolderEnvironmentAndAffinity) {
  const tests::TemporaryFolder folder;
  ::setenv("CLS_TEST_INHERITED", "1", 1);
  MarkedHost processes;
  CommandPlan plan =
      fake({"print", "", "print", "a  'b' \"c\" $d *", "print-folder", "print-variable", "HOME",
            "print-variable", "CLS_TEST_NEW", "print-cpus"});

  plan.folder = folder.path();
  plan.environment = {{"HOME", std::nullopt}, {"CLS_TEST_NEW", "x y"}};
  plan.cpus = {0};
  const auto child = processes.start(plan);

  ASSERT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(child->last_lines(),
            (Lines{"", "a  'b' \"c\" $d *",
                   "folder: " + std::filesystem::canonical(folder.path()).string(), "unset",
                   "value: x y", "cpus: 0"}));
}

TEST(ProcessHost, WritesLogOfEachChild) {
  const tests::TemporaryFolder folder;
  MarkedHost processes;
  CommandPlan plan = fake({"print", "one", "repeat", "1000", "again", "print-part", "end"});
  plan.log = folder.path() / "fake.log";
  const auto child = processes.start(plan);

  ASSERT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(tests::read_file(plan.log), "one\nagain\n  ×1000\nend\n");
  EXPECT_EQ(child->log_error(), "");

  plan.log = "/dev/full";
  const auto unlucky = processes.start(plan);
  ASSERT_TRUE(unlucky->wait_gone(10s));
  EXPECT_EQ(unlucky->log_error(), "writing /dev/full failed: No space left on device");
}

TEST(ProcessHost, StopsChildThatExitsOnSigterm) {
  MarkedHost processes;
  const auto child = processes.start_fake({"exit-on-term", "print", "up", "hang"});
  ASSERT_TRUE(saw_line(*child, "up"));

  const auto begin = Clock::now();
  child->end(10s);
  ASSERT_TRUE(child->wait_gone(5s));
  EXPECT_LT(Clock::now() - begin, 1s);
  EXPECT_EQ(to_text(*child->status().exit), "exit code 0");
  EXPECT_TRUE(processes.nothing_left());
}

TEST(ProcessHost, KillsChildThatIgnoresSigtermAfterGrace) {
  MarkedHost processes;
  const auto child = processes.start_fake({"ignore-term", "print", "up", "hang"});
  ASSERT_TRUE(saw_line(*child, "up"));

  const auto begin = Clock::now();
  child->end(300ms);
  ASSERT_TRUE(child->wait_gone(5s));
  EXPECT_GE(Clock::now() - begin, 300ms);
  EXPECT_LT(Clock::now() - begin, 1500ms);
  EXPECT_EQ(to_text(*child->status().exit), "killed by SIGKILL");
  EXPECT_TRUE(processes.nothing_left());
}

TEST(ProcessHost, TerminatesStoppedChild) {
  MarkedHost processes;
  const auto child = processes.start_fake({"print", "up", "stop", "hang"});
  ASSERT_TRUE(saw_line(*child, "up"));
  child->end(2s);
  ASSERT_TRUE(child->wait_gone(5s));
  EXPECT_EQ(to_text(*child->status().exit), "killed by SIGTERM");
}

TEST(ProcessHost, TerminatesDaemonizedDescendants) {
  MarkedHost processes;
  const auto child = processes.start_fake(
      {"grandchild", "stubborn-grandchild", "grandchild", "print", "up", "hang"});
  ASSERT_TRUE(saw_line(*child, "up"));
  EXPECT_EQ(tests::marked_processes(processes.mark).size(), 4U);
  child->end(200ms);
  ASSERT_TRUE(child->wait_gone(5s));
  EXPECT_TRUE(processes.nothing_left());
}

TEST(ProcessHost, DistinguishesScriptThatLeavesWorkersFromExit) {
  MarkedHost processes;
  const auto child = processes.start_fake({"grandchild", "exit", "0"});
  ASSERT_TRUE(child->wait_exit(10s));
  EXPECT_EQ(child->status().living, 1);
  EXPECT_FALSE(child->status().gone);
  EXPECT_FALSE(has_ended(child->status()));
  EXPECT_FALSE(child->wait_gone(100ms));

  child->end(1s);
  ASSERT_TRUE(child->wait_gone(5s));
  EXPECT_TRUE(has_ended(child->status()));
  EXPECT_TRUE(processes.nothing_left());
}

TEST(ProcessHost, PassesOnlyNamedVariablesIfThePlanSaysSo) {
  MarkedHost processes;
  ::setenv("CLS_TEST_SECRET", "hunter2", 1);
  CommandPlan plan = fake(
      {"print-variable", "PATH", "print-variable", "CLS_TEST_SECRET", "print-variable", "GIVEN"});
  plan.empty_environment = true;
  plan.environment = {{"GIVEN", "value"}};
  const auto child = processes.start(plan);

  ASSERT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(child->last_lines(), (Lines{"unset ×2", "value: value"}));
}

TEST(ProcessHost, TreatsFailedScriptAsEndedDespiteWorkers) {
  MarkedHost processes;
  const auto child = processes.start_fake({"grandchild", "exit", "2"});
  ASSERT_TRUE(child->wait_exit(10s));
  EXPECT_EQ(child->status().living, 1);
  EXPECT_TRUE(has_ended(child->status()));
}

TEST(ProcessHost, TerminatesProgramBeforeDescendantsWhenGentle) {
  MarkedHost processes;
  // The shell waits for its worker, so a signal to the shell alone leaves the worker. The worker
  // says that it is up: between fork and exec it would still have the shell's trap and lose the
  // signal.
  const std::string worker = tests::built("cls_fake_process") + " exit-on-term print up hang";
  const auto child = processes.start(
      shell_command("shell", "trap 'echo asked; exit 7' TERM; " + worker + " & wait"));
  ASSERT_TRUE(saw_line(*child, "up"));

  child->end(5s, true);
  ASSERT_TRUE(child->wait_gone(4s));
  EXPECT_EQ(to_text(*child->status().exit), "exit code 7");
  EXPECT_EQ(child->last_lines().back(), "asked");
  EXPECT_TRUE(processes.nothing_left());
}

TEST(ProcessHost, TerminatesChildOnDestruction) {
  MarkedHost processes;
  auto child = processes.start_fake({"grandchild", "print", "up", "hang"});
  ASSERT_TRUE(saw_line(*child, "up"));
  child.reset();
  EXPECT_TRUE(processes.nothing_left(2s));
}

TEST(ProcessHost, TerminatesAllChildrenOnDestruction) {
  std::shared_ptr<Child> child;
  std::string mark;

  {
    MarkedHost processes;
    mark = processes.mark;
    child = processes.start_fake({"ignore-term", "print", "up", "hang"});
    processes.start_fake({"hang"});
    ASSERT_TRUE(saw_line(*child, "up"));
  }

  EXPECT_TRUE(tests::all_marked_gone(mark, 0ms));
  EXPECT_TRUE(child->status().gone);
  EXPECT_EQ(to_text(*child->status().exit), "killed by SIGKILL");
}

TEST(ProcessHost, TerminatesManyChildrenConcurrently) {
  MarkedHost processes;
  std::vector<std::shared_ptr<Child>> children;
  for (int i = 0; i < 26; ++i) {
    children.push_back(processes.start_fake({"grandchild", "ignore-term", "print", "up", "hang"}));
  }
  for (const auto& child : children) ASSERT_TRUE(saw_line(*child, "up"));
  EXPECT_EQ(tests::marked_processes(processes.mark).size(), 52U);
  EXPECT_TRUE(processes.host.end_all(300ms));

  for (const auto& child : children) EXPECT_TRUE(child->status().gone);
  EXPECT_TRUE(processes.nothing_left());
}

TEST(ProcessHost, LimitsLogOfFloodingChild) {
  const tests::TemporaryFolder folder;
  MarkedHost processes;
  auto host = ProcessHost::create(100'000);
  ASSERT_TRUE(host);

  CommandPlan plan = fake({"flood"});
  plan.log = folder.path() / "flood.log";
  plan.environment = {{tests::kMarkVariable, processes.mark}};
  auto flood = host->start(plan);
  ASSERT_TRUE(flood);

  const auto other = processes.start_fake({"sleep", "0.2", "print", "done"});
  EXPECT_TRUE(saw_line(*other, "done"));
  std::this_thread::sleep_for(200ms);
  (*flood)->end(1s);
  ASSERT_TRUE((*flood)->wait_gone(5s));
  EXPECT_LT(std::filesystem::file_size(plan.log), 110'000U);
  EXPECT_EQ((*flood)->last_lines().size(), 50U);
  EXPECT_TRUE(processes.nothing_left());
}

TEST(ProcessHost, MeasuresCpuTimeOfAllDescendants) {
  MarkedHost processes;
  const auto child = processes.start_fake(
      {"burn", "0.2", "burning-child", "0.3", "print", "half", "sleep", "0.3", "burn", "0.2"});
  ASSERT_TRUE(saw_line(*child, "half"));

  const double half = child->cpu_seconds();
  EXPECT_GE(half, 0.47);
  EXPECT_LE(half, 0.65);
  ASSERT_TRUE(child->wait_gone(10s));
  EXPECT_GE(child->cpu_seconds(), 0.67);
  EXPECT_LE(child->cpu_seconds(), 0.9);
}

TEST(ProcessHost, DistinguishesReadinessFromEarlyExit) {
  MarkedHost processes;
  std::atomic<int> stop{0};
  const auto never = [] { return false; };
  const auto dies = processes.start_fake({"sleep", "0.05", "exit", "1"});
  EXPECT_EQ(wait_until_ready(*dies, never, 10s, stop), Readiness::kEnded);

  const auto hangs = processes.start_fake({"hang"});
  EXPECT_EQ(wait_until_ready(*hangs, never, 50ms, stop), Readiness::kTimedOut);
  stop = SIGINT;
  EXPECT_EQ(wait_until_ready(*hangs, never, 10s, stop), Readiness::kInterrupted);
}

TEST(ProcessHost, CallsBackForEachLine) {
  MarkedHost processes;
  std::atomic<int> lines{0};
  const auto child = processes.start(fake({"repeat", "500", "x", "count", "500"}),
                                     [&](std::string_view) { ++lines; });
  ASSERT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(lines.load(), 1000);
}

// A soccer server that was slow to end printed into a match that was gone.
TEST(ProcessHost, CallsNobodyBackOnceTheChildIsDropped) {
  MarkedHost processes;
  std::atomic<int> lines = 0;
  auto child = processes.start(
      fake({"ignore-term", "print", "first", "sleep", "0.4", "print", "second", "hang"}),
      [&lines](std::string_view) { ++lines; });
  ASSERT_TRUE(saw_line(*child, "first"));
  child.reset();
  const int before = lines;
  EXPECT_TRUE(processes.nothing_left(20s));
  EXPECT_TRUE(processes.host.end_all(0ms));
  EXPECT_EQ(lines, before);
}

TEST(ProcessHost, KillsProgramWithItsKeeper) {
  MarkedHost processes;
  const auto child = processes.start_fake({"grandchild", "print", "up", "hang"});
  ASSERT_TRUE(saw_line(*child, "up"));

  const int pid = child->status().pid;
  int keeper = 0;
  for (const ProcessEntry& entry : descendants_of(::getpid())) {
    if (entry.pid == pid) keeper = entry.parent;
  }
  ASSERT_GT(keeper, 0);

  ::kill(keeper, SIGKILL);
  ASSERT_TRUE(child->wait_gone(5s));
  EXPECT_TRUE(processes.nothing_left(2s));
  EXPECT_EQ(to_text(*child->status().exit), "killed by SIGKILL");
  // Other programs can still be started.
  EXPECT_TRUE(processes.start_fake({"exit", "0"})->wait_gone(5s));
}

TEST(ProcessHost, ClosesAllDescriptors) {
  const auto open_fds = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
  };
  MarkedHost processes;
  processes.start_fake({"exit", "0"})->wait_gone(5s);
  const auto before = open_fds();

  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(processes.start_fake({"print", "x"})->wait_gone(5s));
  }
  EXPECT_EQ(open_fds(), before);
}

// Two busy programs on one processor: each waits for it while the other one runs.
TEST(ProcessHost, KnowsHowLongProgramsWaitedForAProcessor) {
  MarkedHost processes;
  const auto busy = [&processes] {
    CommandPlan plan = shell_command("busy", "while :; do :; done");
    plan.cpus = {0};
    return processes.start(plan);
  };
  const auto first = busy();
  const auto second = busy();
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  for (const auto& child : {first, second}) child->end(std::chrono::milliseconds(10));
  for (const auto& child : {first, second}) {
    EXPECT_TRUE(child->wait_gone(std::chrono::seconds(5)));
    EXPECT_GT(child->delayed_seconds(), 0.05);
    EXPECT_LT(child->delayed_seconds(), 5.0);
  }
}

}  // namespace
}  // namespace cls::process
