// The folder for temporary files: its place, its end, and the error where there is none.
#include "process/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

/// Runs each test with a folder of its own in TMPDIR.
class ScratchFolderTest : public testing::Test {
 protected:
  ScratchFolderTest() {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
  }
  ~ScratchFolderTest() override {
    if (before_) {
      set(before_->c_str());
    } else {
      ::unsetenv("TMPDIR");
    }
  }

  static void set(const char* folder) { ::setenv("TMPDIR", folder, 1); }

  tests::TemporaryFolder parent_;

 private:
  std::optional<std::string> before_;
};

TEST_F(ScratchFolderTest, IsPrivateAndDeletedWithItsContent) {
  set(parent_.path().c_str());
  {
    auto created = ScratchFolder::create();
    ASSERT_TRUE(created);
    const ScratchFolder folder = *std::move(created);
    fs::create_directories(folder.path() / "a/b");

    EXPECT_EQ(folder.path().parent_path(), parent_.path());
    EXPECT_EQ(fs::status(folder.path()).permissions(), fs::perms::owner_all);
  }
  EXPECT_TRUE(fs::is_empty(parent_.path()));
}

// Root may delete everything, so another user does.
TEST_F(ScratchFolderTest, GoesWithFoldersThatAProgramMadeReadOnly) {
  const fs::path folder = parent_.path() / "scratch";
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    fs::create_directories(folder);
    if (::geteuid() == 0 &&
        (::chown(folder.c_str(), kNobody, kNobody) != 0 ||
         ::chmod(parent_.path().c_str(), 0777) != 0 || ::setuid(kNobody) != 0)) {
      ::_exit(77);
    }
    fs::create_directories(folder / "a/b/c");
    fs::permissions(folder / "a/b", fs::perms(0500));
    fs::permissions(folder / "a", fs::perms(0500));
    remove_tree(folder);
    ::_exit(fs::exists(folder) ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "no other user here";
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST_F(ScratchFolderTest, IsNeverInTheWorkingFolder) {
  set("");
  const auto created = ScratchFolder::create();
  ASSERT_TRUE(created);
  EXPECT_TRUE(created->path().is_absolute()) << created->path();
}

TEST_F(ScratchFolderTest, IsAnErrorWithTheFolderAndTheRemedyWhereItCannotBe) {
  for (const char* folder : {"/nonexistent", "/dev/null", "/proc"}) {
    set(folder);
    const auto created = ScratchFolder::create();
    ASSERT_FALSE(created) << created->path();
    EXPECT_THAT(created.error().message,
                StartsWith(std::string("cannot create a temporary folder in '") + folder + "': "));
    EXPECT_THAT(created.error().message, HasSubstr("; set TMPDIR to a folder"));
  }
}

}  // namespace
}  // namespace cls::process
