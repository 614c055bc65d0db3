// However cls or its guard exits, no started process survives.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "process/process_tree.h"
#include "tests/process/test_guard.h"
#include "tests/support/built.h"
#include "tests/support/files.h"
#include "tests/support/marked_processes.h"
#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

using namespace std::chrono_literals;

// A stand-in for cls (tests/fakes/process_driver.cpp) with its own children, below the test's
// guard.
class GuardDeath : public testing::Test {
 protected:
  // `before`: actions of the fake process that change what the driver inherits.
  void start(std::vector<std::string> arguments, std::vector<std::string> before = {}) {
    before.push_back("exec");
    before.push_back(tests::built("cls_process_driver"));
    before.insert(before.end(), arguments.begin(), arguments.end());
    driver_ = processes_.start(fake(std::move(before)));
    ASSERT_TRUE(saw_line(*driver_, "ready")) << testing::PrintToString(driver_->last_lines());
  }

  static std::string fake_line(const std::string& actions) {
    return "exec " + tests::built("cls_fake_process") + " " + actions;
  }

  std::vector<std::string> usual_children() const {
    return {fake_line("hang"), fake_line("ignore-term hang"),
            fake_line("grandchild stubborn-grandchild hang"),
            tests::built("cls_fake_process") + " hang & wait"};
  }

  int guard_pid() const { return std::stoi(driver_->last_lines().front().substr(6)); }

  MarkedHost processes_;
  std::shared_ptr<Child> driver_;
};

TEST_F(GuardDeath, LeavesNoProcess2sAfterKillNineOfCls) {
  start(usual_children());
  ASSERT_GT(tests::marked_processes(processes_.mark).size(), 8U);
  ::kill(driver_->status().pid, SIGKILL);
  EXPECT_TRUE(processes_.nothing_left(2s));
}

TEST_F(GuardDeath, WorksWithIgnoredSignalsAndClosedStreams) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path seen = folder.path() / "seen";
  std::vector<std::string> children = usual_children();
  children.push_back(fake_line("print-signals print-fds print-input hang >") + seen.string());
  start(children, {"spoil-signals", "close", "0"});
  const auto complete = [&] {
    return std::filesystem::exists(seen) &&
           tests::read_file(seen).find("input") != std::string::npos;
  };
  while (!complete()) std::this_thread::sleep_for(10ms);
  EXPECT_EQ(tests::read_file(seen), "signals:\nfds: 0 1 2\nno input\n");

  ::kill(driver_->status().pid, SIGKILL);
  EXPECT_TRUE(processes_.nothing_left(2s));
}

TEST_F(GuardDeath, LeavesNoProcessAfterNormalExit) {
  std::vector<std::string> arguments = usual_children();
  arguments.push_back("return");
  start(arguments, {"spoil-signals", "close", "0"});
  ASSERT_TRUE(driver_->wait_exit(5s));
  EXPECT_EQ(driver_->status().living, 0);
  EXPECT_TRUE(processes_.nothing_left());
}

TEST_F(GuardDeath, TerminatesChildrenWhenGuardIsKilled) {
  start(usual_children());
  ::kill(guard_pid(), SIGKILL);
  ::kill(driver_->status().pid, SIGKILL);
  EXPECT_TRUE(processes_.nothing_left(2s));
}

TEST_F(GuardDeath, LeavesNoProcessAfterSigtermToAll) {
  start(usual_children());
  for (const int pid : tests::marked_processes(processes_.mark)) ::kill(pid, SIGTERM);
  EXPECT_TRUE(processes_.nothing_left(2s));
}

TEST_F(GuardDeath, TerminatesInnerTreeWithOuterChild) {
  start(usual_children());
  driver_->end(1s);
  EXPECT_TRUE(driver_->wait_gone(3s));
  EXPECT_TRUE(processes_.nothing_left());
}

// The outer guard inherits the driver and its guard, which has something to clean up.
TEST_F(GuardDeath, InnerGuardDeletesItsFoldersWhenTheOuterKeeperIsKilled) {
  std::vector<std::string> arguments = usual_children();
  arguments.push_back("scratch");
  start(arguments);
  const std::filesystem::path scratch = driver_->last_lines().at(1);
  ASSERT_TRUE(std::filesystem::is_directory(scratch)) << scratch;

  const auto driver = read_process(driver_->status().pid);
  ASSERT_TRUE(driver);
  ::kill(driver->parent, SIGKILL);
  EXPECT_TRUE(processes_.nothing_left(3s));
  EXPECT_FALSE(std::filesystem::exists(scratch));
}

TEST_F(GuardDeath, KeepsNoInheritedFileOpen) {
  start({fake_line("hang")});
  const std::string folder = "/proc/" + std::to_string(guard_pid()) + "/fd";
  int sockets = 0;

  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string target = std::filesystem::read_symlink(entry.path()).string();
    if (target.starts_with("socket:")) ++sockets;
    EXPECT_TRUE(target == "/dev/null" || target.starts_with("socket:") ||
                target == "anon_inode:[signalfd]")
        << target;
  }
  EXPECT_EQ(sockets, 1);
}

}  // namespace
}  // namespace cls::process
