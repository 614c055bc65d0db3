// Limits of control groups, from files as both versions of the kernel's interface write them.
#include "base/system/control_group.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace cls::base {
namespace {

namespace fs = std::filesystem;

class ControlGroup : public testing::Test {
 protected:
  void write(const fs::path& name, const std::string& text) const {
    fs::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name) << text;
  }
  ControlGroupFiles files() const { return {folder_.path() / "cgroup", folder_.path() / "sys"}; }

  tests::TemporaryFolder folder_;
};

TEST_F(ControlGroup, QuotaIsThatOfTheNarrowestGroupRoundedUp) {
  EXPECT_EQ(processor_quota(files()), std::nullopt);
  write("cgroup", "0::/user/job\n");
  write("sys/cpu.max", "max 100000\n");
  EXPECT_EQ(processor_quota(files()), std::nullopt);
  write("sys/user/cpu.max", "350000 100000\n");
  EXPECT_EQ(processor_quota(files()), 4);
  write("sys/user/job/cpu.max", "50000 100000\n");
  EXPECT_EQ(processor_quota(files()), 1);
  write("sys/user/job/cpu.max", "200000 100000\n");
  EXPECT_EQ(processor_quota(files()), 2);
}

TEST_F(ControlGroup, QuotaOfTheFirstVersion) {
  write("cgroup", "4:memory:/a\n2:cpu,cpuacct:/box\n");
  write("sys/cpu/box/cpu.cfs_quota_us", "-1\n");
  write("sys/cpu/box/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(processor_quota(files()), std::nullopt);
  write("sys/cpu/box/cpu.cfs_quota_us", "150000\n");
  EXPECT_EQ(processor_quota(files()), 2);
}

// In a container the path is that of the host, and the root shows the group of the container.
TEST_F(ControlGroup, QuotaOfAContainer) {
  write("cgroup", "0::/docker/1234\n");
  write("sys/cpu.max", "100000 100000\n");
  EXPECT_EQ(processor_quota(files()), 1);
}

TEST_F(ControlGroup, CountsProcessesKilledForWantOfMemory) {
  write("cgroup", "0::/job\n7:memory:/old\n3:pids:/old\n");
  write("sys/job/memory.events", "low 0\noom 1\noom_kill 2\n");
  write("sys/job/memory.max", "62914560\n");
  write("sys/memory/old/memory.oom_control", "oom_kill_disable 0\noom_kill 3\n");
  write("sys/memory/old/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(memory_kills(files()).count, 5);
  EXPECT_EQ(memory_kills(files()).limit, 62914560U);

  EXPECT_EQ(process_limit(files()), std::nullopt);
  write("sys/pids/old/pids.max", "12\n");
  write("sys/job/pids.max", "max\n");
  EXPECT_EQ(process_limit(files()), 12);
}

}  // namespace
}  // namespace cls::base
