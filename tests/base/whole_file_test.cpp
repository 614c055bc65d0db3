// Atomic and durable writes of small files.
#include "base/io/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace {

using testing::HasSubstr;

struct Sync {
  bool folder = false;
  off_t size = 0;
  bool renamed = false;  ///< the target existed
};
std::vector<Sync> syncs;
std::string target;

}  // namespace

// Replaces the function of the C library in this program.
extern "C" int fsync(int fd) {
  struct stat file {};
  struct stat renamed {};
  ::fstat(fd, &file);
  syncs.push_back({S_ISDIR(file.st_mode), file.st_size, ::stat(target.c_str(), &renamed) == 0});
  return static_cast<int>(::syscall(SYS_fsync, fd));
}

namespace cls::base {
namespace {

TEST(WriteFileDurably, SyncsTheContentBeforeTheRenameAndTheNameAfterIt) {
  tests::TemporaryFolder folder;
  target = folder.path() / "plan.toml";
  syncs.clear();
  ASSERT_TRUE(write_file_durably(target, "seed = 7\n"));
  ASSERT_EQ(syncs.size(), 2u);
  EXPECT_FALSE(syncs[0].folder);
  EXPECT_EQ(syncs[0].size, 9);
  EXPECT_FALSE(syncs[0].renamed);
  EXPECT_TRUE(syncs[1].folder);
  EXPECT_TRUE(syncs[1].renamed);
  EXPECT_EQ(read_file(target), "seed = 7\n");
  EXPECT_FALSE(std::filesystem::exists(target + ".tmp"));
}

TEST(WriteFile, ReplacesAFileAtomicallyWithoutSync) {
  tests::TemporaryFolder folder;
  target = folder.path() / "page.html";
  syncs.clear();
  ASSERT_TRUE(write_file(target, "old"));
  ASSERT_TRUE(write_file(target, "new"));
  EXPECT_TRUE(syncs.empty());
  EXPECT_EQ(read_file(target), "new");
}

TEST(WriteFile, LeavesTheOldFileAndNoTemporaryOneOnAFullDisk) {
  tests::TemporaryFolder folder;
  target = folder.path() / "result.json";
  ASSERT_TRUE(write_file(target, "old"));
  std::filesystem::create_symlink("/dev/full", target + ".tmp");
  const auto written = write_file(target, "new");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("No space left")) << written.error().message;
  EXPECT_EQ(read_file(target), "old");
  EXPECT_FALSE(std::filesystem::is_symlink(target + ".tmp"));
}

TEST(WriteFile, LeavesNoTemporaryFileBesideAFolderOfThatName) {
  tests::TemporaryFolder folder;
  target = folder.path() / "result.json";
  std::filesystem::create_directory(target);
  EXPECT_FALSE(write_file(target, "new"));
  EXPECT_FALSE(std::filesystem::exists(target + ".tmp"));
}

}  // namespace
}  // namespace cls::base
