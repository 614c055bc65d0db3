// Space on disks.
#include "base/io/disk_space.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/temporary_folder.h"

namespace cls::base {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20;

void write_megabytes(const fs::path& file, std::size_t count) {
  std::ofstream(file) << std::string(count * kMegabyte, 'x');
}

TEST(DiskSpace, OfAFolderIsThatOfItsFiles) {
  const tests::TemporaryFolder folder;
  const fs::path inner = folder.path() / "inner";
  fs::create_directory(inner);
  write_megabytes(folder.path() / "file", 2);
  write_megabytes(inner / "file", 3);
  fs::create_hard_link(inner / "file", folder.path() / "same");
  fs::create_symlink(folder.path() / "file", inner / "link");
  std::ofstream(folder.path() / "hole").seekp(std::streamoff(kMegabyte * 900)).put('x');

  EXPECT_GE(bytes_below({folder.path()}), 5 * kMegabyte);
  EXPECT_LT(bytes_below({folder.path()}), 6 * kMegabyte);
  EXPECT_EQ(bytes_below({folder.path(), inner}), bytes_below({folder.path()}));
  EXPECT_EQ(bytes_below({folder.path() / "none"}), 0U);
}

TEST(DiskSpace, IsKeptUntilItIsReleased) {
  const tests::TemporaryFolder folder;
  constexpr std::uint64_t kKept = 64 * kMegabyte;
  const std::uint64_t before = free_bytes(folder.path());
  if (before < 4 * kKept) GTEST_SKIP() << "too little space";
  KeptSpace kept(folder.path(), kKept);
  const std::uint64_t meanwhile = free_bytes(folder.path());
  EXPECT_TRUE(fs::is_empty(folder.path()));
  kept.release();
  // Other programs use the disk, too.
  EXPECT_LT(meanwhile, before - kKept / 2);
  EXPECT_GT(free_bytes(folder.path()), meanwhile + kKept / 2);
}

TEST(DiskSpace, OfNoFolderIsUnknown) {
  EXPECT_EQ(free_bytes("/none/here"), 0U);
  EXPECT_EQ(device_of("/none/here"), 0U);
  KeptSpace("/none/here", kMegabyte).release();
}

}  // namespace
}  // namespace cls::base
