// What programs use: processes, memory that they share or not, files without a name.
#include "process/program_use.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/io/disk_space.h"
#include "tests/process/test_guard.h"
#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20;
constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

class ProgramUseTest : public testing::Test {
 protected:
  /// Runs until the end of the test; returns once it has printed "ready".
  void start(const std::string& name, const std::string& command) {
    CommandPlan plan = shell_command(name, command);
    plan.folder = folder_.path();
    const auto child = processes_.start(plan);
    children_.push_back(child);
    EXPECT_TRUE(saw_line(*child, "ready"));
  }

  tests::TemporaryFolder folder_;
  MarkedHost processes_;
  std::vector<std::shared_ptr<Child>> children_;
};

TEST_F(ProgramUseTest, CountsProcessesAndThreadsOfOneSideOnly) {
  start("left team", "sleep 30 & sleep 30 & echo ready; wait");
  start("left coach", "echo ready; sleep 30 & wait");
  start("right team", "sleep 30 & echo ready; wait");
  EXPECT_EQ(use_of_programs("left ", kNever).processes, 5);
  EXPECT_EQ(use_of_programs("right ", kNever).processes, 2);
  EXPECT_EQ(use_of_programs("none ", kNever).processes, 0);

  start("right coach",
        "exec python3 -c 'import threading, time\n"
        "for i in range(3): threading.Thread(target=time.sleep, args=(30,)).start()\n"
        "print(\"ready\", flush=True)\ntime.sleep(30)'");
  EXPECT_EQ(use_of_programs("right ", kNever).processes, 6);
}

// A child that a script leaves to others is still one of its program.
TEST_F(ProgramUseTest, CountsWhatAProgramHasLeft) {
  start("left team", "(sleep 30 &) ; echo ready; exec sleep 30");
  EXPECT_EQ(use_of_programs("left ", kNever).processes, 2);
}

TEST_F(ProgramUseTest, CountsSharedMemoryOnceWhereItMatters) {
  start("left team",
        "exec python3 -c 'import os, time\n"
        "all = bytearray(b\"x\" * (48 << 20))\n"
        "for i in range(3):\n"
        "  if os.fork() == 0: time.sleep(30)\n"
        "print(\"ready\", flush=True)\ntime.sleep(30)'");
  const std::uint64_t quick = use_of_programs("left ", kNever).memory;
  EXPECT_GT(quick, 4 * 48 * kMegabyte);
  const std::uint64_t exact = use_of_programs("left ", quick / 2).memory;
  EXPECT_GT(exact, 48 * kMegabyte);
  EXPECT_LT(exact, 96 * kMegabyte);
}

TEST_F(ProgramUseTest, CountsOpenFilesWithoutAName) {
  start("left team",
        "exec python3 -c 'import os, time\n"
        "file = open(\"hidden\", \"wb\")\nos.unlink(\"hidden\")\n"
        "file.write(b\"x\" * (4 << 20))\nfile.flush()\n"
        "twice = os.dup(file.fileno())\n"
        "print(\"ready\", flush=True)\ntime.sleep(30)'");
  const std::set<dev_t> devices = {base::device_of(folder_.path())};
  EXPECT_GE(unnamed_bytes_of_programs("left ", devices), 4 * kMegabyte);
  EXPECT_LT(unnamed_bytes_of_programs("left ", devices), 6 * kMegabyte);
  EXPECT_EQ(unnamed_bytes_of_programs("left ", {}), 0U);
  EXPECT_LT(base::bytes_below({folder_.path()}), kMegabyte);
}

}  // namespace
}  // namespace cls::process
