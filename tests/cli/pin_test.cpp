// `--pin`: programs and agents of each side run on its half of the processor cores.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "base/system/host.h"
#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/port_lock.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Processors = std::vector<int>;
using Arguments = std::vector<std::string>;

cpu_set_t set_of(const Processors& processors) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int processor : processors) CPU_SET(static_cast<std::size_t>(processor), &set);
  return set;
}

/// Number of threads of the process pinned to exactly these cores.
long threads_on(int pid, const Processors& processors) {
  const cpu_set_t wanted = set_of(processors);
  long count = 0;
  std::error_code code;
  for (fs::directory_iterator task("/proc/" + std::to_string(pid) + "/task", code), end;
       !code && task != end; task.increment(code)) {
    cpu_set_t set;
    CPU_ZERO(&set);
    const int thread = std::stoi(task->path().filename());
    if (::sched_getaffinity(thread, sizeof set, &set) != 0) continue;
    if (CPU_EQUAL(&set, &wanted)) ++count;
  }
  return count;
}

std::string line_of(Processors processors) {
  std::ranges::sort(processors);
  std::string line = "cpus:";
  for (const int processor : processors) line += " " + std::to_string(processor);
  return line + "\n";
}

class Pin : public testing::Test {
 protected:
  void SetUp() override {
    if (halves_[0].empty()) GTEST_SKIP() << "only one usable processor core";
  }

  static std::string playmaker() {
    return "run:exec " + built("cls_fake_playmaker") + " --port {port} --print-cpus 1";
  }

  Arguments match(const std::string& left, const std::string& right,
                  const Arguments& more = {}) const {
    const Arguments argv = joined({cls_binary(), "match", left, right, "--pin", "--dir", match(),
                                   "--set", "server::kick_off_wait=3"},
                                  more);
    return argv;
  }
  std::string match() const { return folder_.path() / "match"; }

  std::string log(const std::string& name) const {
    const fs::path file = fs::path(match()) / name;
    return fs::exists(file) ? read_file(file) : std::string();
  }

  /// Waits while the match runs.
  static bool wait_for(const std::function<bool()>& reached) {
    const auto begin = std::chrono::steady_clock::now();
    while (!reached() && std::chrono::steady_clock::now() - begin < 30s) {
      std::this_thread::sleep_for(5ms);
    }
    return reached();
  }

  TemporaryFolder folder_;
  const std::array<Processors, 2> halves_ = cls::base::split_in_half(cls::base::allowed_cores());
};

TEST_F(Pin, PinsPlaymakersAndAgentsOfEachSide) {
  Command command(match(playmaker(), playmaker()));
  EXPECT_TRUE(wait_for(
      [&] { return !log("left-playmaker.log").empty() && !log("right-playmaker.log").empty(); }));
  EXPECT_EQ(log("left-playmaker.log"), line_of(halves_[0]));
  EXPECT_EQ(log("right-playmaker.log"), line_of(halves_[1]));
  for (const Processors& half : halves_) {
    EXPECT_TRUE(wait_for([&] { return threads_on(command.pid(), half) > 0; }));
  }
  // Processes of neither side are not pinned.
  EXPECT_GT(threads_on(command.pid(), cls::base::allowed_processors()), 0);
  command.send_signal(SIGTERM);
  EXPECT_EQ(command.finish().exit_code, 143);
}

TEST_F(Pin, PinsProcessesOfExternalTeam) {
  const fs::path team = folder_.path() / "team";
  fs::create_directory(team);
  std::ofstream(team / "start.sh")
      << "#!/bin/sh\nwhile [ $# -gt 0 ]; do case $1 in -p) port=$2;; -t) name=$2;; esac; shift 2; "
         "done\nexec "
      << copy_built("cls_fake_player", team)
      << " --port $port --name $name --players 11 --print-cpus 1\n";
  ::chmod((team / "start.sh").c_str(), 0755);
  const PortLock ports;
  Command command(match("mock:hold", "team:" + team.string()));

  EXPECT_TRUE(wait_for([&] { return !log("right-team.log").empty(); }));
  EXPECT_EQ(log("right-team.log").substr(0, line_of(halves_[1]).size()), line_of(halves_[1]));
  EXPECT_TRUE(wait_for([&] { return threads_on(command.pid(), halves_[0]) > 0; }));
  EXPECT_EQ(threads_on(command.pid(), halves_[1]), 0) << "the right side has no cls agents";

  command.send_signal(SIGTERM);
  EXPECT_EQ(command.finish().exit_code, 143);
}

TEST_F(Pin, PinsNothingByDefault) {
  Arguments argv = match(playmaker(), "mock:hold");
  argv.erase(std::ranges::find(argv, "--pin"));
  Command command(argv);
  EXPECT_TRUE(wait_for([&] { return !log("left-playmaker.log").empty(); }));
  EXPECT_EQ(log("left-playmaker.log"), line_of(cls::base::allowed_processors()));
  command.send_signal(SIGTERM);
  EXPECT_EQ(command.finish().exit_code, 143);
}

TEST_F(Pin, DryRunPrintsPinnedCommands) {
  const auto printed = run(match(playmaker(), playmaker(), {"--dry-run"}));
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  for (const Processors& half : halves_) {
    EXPECT_THAT(printed.out, HasSubstr("taskset -c " + std::to_string(half.front())));
  }
}

TEST(PinOnOneProcessor, ReportsError) {
  const Processors all = cls::base::allowed_processors();
  const cpu_set_t before = set_of(all);
  const cpu_set_t one = set_of({all.front()});
  ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);
  const auto answer = run({cls_binary(), "match", "mock", "mock", "--pin", "--dry-run"});
  ASSERT_EQ(::sched_setaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(answer.exit_code, 2);
  EXPECT_THAT(answer.err, HasSubstr("--pin: only one processor core is available"));
}

}  // namespace
}  // namespace cls::tests
