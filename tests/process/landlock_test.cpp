// Programs that may use some files only. On a kernel without Landlock there is nothing to test
// here; what matches do then is tested by Sandbox.WarnsOnAKernelWithoutLandlock.
#include "process/landlock.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include "process/process_host.h"
#include "tests/process/test_guard.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class Landlock : public testing::Test {
 protected:
  void SetUp() override {
    if (landlock_version() == 0) GTEST_SKIP() << "this kernel has no Landlock";
    for (const char* name : {"own", "others"}) {
      fs::create_directory(path(name));
      std::ofstream(path(name) / "file") << name << '\n';
    }
  }

  fs::path path(const std::string& name) const { return folder_.path() / name; }

  /// The exit code of a shell that may change "own" and read the system, as the last line of
  /// output.
  int exit_code_of(const std::string& command) {
    CommandPlan plan = shell_command("the shell", command);
    plan.folder = path("own");
    plan.files = {{"/usr", "/bin", "/lib", "/lib64"}, {path("own"), "/dev/null", "/none"}};
    const auto child = processes_.start(plan);
    EXPECT_TRUE(child->wait_gone(20s));
    return child->status().exit->by_signal ? -1 : child->status().exit->number;
  }

  std::string others() const { return tests::read_file(path("others") / "file"); }

  tests::TemporaryFolder folder_;
  MarkedHost processes_;
};

TEST_F(Landlock, AllowsReadingAndChangingOwnFiles) {
  EXPECT_EQ(exit_code_of("cat file && echo more >> file && mkdir sub && mv file sub/moved && "
                         ": > sub/moved && ln -s sub link && rm -r sub && echo x > /dev/null"),
            0);
  EXPECT_FALSE(fs::exists(path("own") / "file"));
}

TEST_F(Landlock, ForbidsFilesOfOthers) {
  for (const char* command :
       {"cat ../others/file", "ls ../others", "echo x >> ../others/file", "echo x > ../others/new",
        "rm ../others/file", "mv ../others/file .", "ln ../others/file here", "mkdir ../others/sub",
        "cp file ../others/file", "ln -s ../others/file link && cat link"}) {
    EXPECT_NE(exit_code_of(command), 0) << command;
  }
  EXPECT_EQ(others(), "others\n");
  EXPECT_FALSE(fs::exists(path("others") / "new"));
}

TEST_F(Landlock, ForbidsEmptyingFilesOfOthersSinceVersion3) {
  if (landlock_version() < 3) GTEST_SKIP() << "version " << landlock_version();
  EXPECT_NE(exit_code_of("truncate -s 0 ../others/file"), 0);
  EXPECT_EQ(others(), "others\n");
  EXPECT_EQ(exit_code_of("truncate -s 0 file"), 0);
}

TEST_F(Landlock, ForbidsSignalsToOthersSinceVersion6) {
  if (landlock_version() < 6) GTEST_SKIP() << "version " << landlock_version();
  EXPECT_NE(exit_code_of("kill -0 $PPID"), 0);
  EXPECT_NE(exit_code_of("setsid sh -c 'kill -0 " + std::to_string(::getpid()) + "'"), 0);
  EXPECT_EQ(exit_code_of("sleep 60 & kill $! && kill -0 $$"), 0);
}

TEST_F(Landlock, HoldsForDescendants) {
  EXPECT_NE(exit_code_of("sh -c 'setsid cat ../others/file'"), 0);
}

TEST_F(Landlock, HidesTheVariablesOfItsParents) {
  EXPECT_NE(exit_code_of("cat /proc/$PPID/environ"), 0);
}

TEST_F(Landlock, RefusesAProgramThatItCannotRead) {
  CommandPlan plan = shell_command("the shell", "true");
  plan.files = {{"/etc"}, {}};
  EXPECT_EQ(processes_.host.start(plan).error().message,
            "cannot start the shell: /bin/sh: Permission denied");
}

}  // namespace
}  // namespace cls::process
