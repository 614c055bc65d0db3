// Limits of memory and CPU time. The programs are those of the system: a sanitizer's shadow memory
// counts as memory of a program of this build.
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "process/process_host.h"
#include "tests/process/test_guard.h"

namespace cls::process {
namespace {

using namespace std::chrono_literals;

constexpr const char* kBurn = "while :; do :; done";
constexpr const char* kAllocate = "dd if=/dev/zero of=/dev/null bs=64M count=1";

Child::Status status_of(MarkedHost& processes, const std::string& command, ResourceLimits limits) {
  CommandPlan plan = shell_command("the shell", command);
  plan.limits = limits;
  const auto child = processes.start(plan);
  EXPECT_TRUE(child->wait_gone(60s));
  return child->status();
}

TEST(ResourceLimits, EndProcessAtItsLimitOfCpuTime) {
  MarkedHost processes;
  const Child::Status status = status_of(processes, kBurn, {0, 1});
  EXPECT_EQ(to_text(*status.exit), "killed by SIGXCPU");
  EXPECT_TRUE(status.at_cpu_limit);
}

TEST(ResourceLimits, KillProcessThatIgnoresTheSignal) {
  MarkedHost processes;
  const Child::Status status = status_of(processes, std::string("trap '' XCPU; ") + kBurn, {0, 1});
  EXPECT_EQ(to_text(*status.exit), "killed by SIGKILL");
  EXPECT_TRUE(status.at_cpu_limit);
}

TEST(ResourceLimits, AreNoticedBehindShellsAndScriptsThatHaveEnded) {
  MarkedHost processes;
  const std::string burning = std::string("sh -c '") + kBurn + "'";
  const Child::Status shell = status_of(processes, burning + "; exit $?", {0, 1});
  EXPECT_EQ(to_text(*shell.exit), "exit code 152 (128 + SIGXCPU)");
  EXPECT_TRUE(shell.at_cpu_limit);
  const Child::Status script = status_of(processes, burning + " &", {0, 1});
  EXPECT_EQ(to_text(*script.exit), "exit code 0");
  EXPECT_TRUE(script.at_cpu_limit);
}

TEST(ResourceLimits, AreNotBlamedForOtherEnds) {
  MarkedHost processes;
  EXPECT_FALSE(status_of(processes, "kill -KILL $$", {0, 60}).at_cpu_limit);
  EXPECT_FALSE(status_of(processes, "exit 3", {0, 60}).at_cpu_limit);
  EXPECT_FALSE(status_of(processes, "kill -XCPU $$", {}).at_cpu_limit);
}

TEST(ResourceLimits, RefuseMemoryAboveTheLimit) {
  MarkedHost processes;
  EXPECT_EQ(to_text(*status_of(processes, kAllocate, {32 << 20, 0}).exit), "exit code 1");
  EXPECT_EQ(to_text(*status_of(processes, kAllocate, {256 << 20, 0}).exit), "exit code 0");
}

}  // namespace
}  // namespace cls::process
