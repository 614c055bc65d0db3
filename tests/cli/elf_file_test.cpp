// What programs need to be loaded, and which of them old systems load.
#include "cli/project/elf_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::cli {
namespace {

TEST(ElfFile, HasLoaderLibrariesAndVersions) {
  const auto file = read_elf_file(tests::cls_binary());
  ASSERT_TRUE(file);
  EXPECT_EQ(file->loader, "/lib64/ld-linux-x86-64.so.2");
  EXPECT_THAT(file->needed, testing::Contains("libc.so.6"));
  EXPECT_THAT(file->versions, testing::Contains("GLIBC_2.2.5"));
}

TEST(ElfFile, IsNothingForOtherAndCorruptFiles) {
  const tests::TemporaryFolder folder;
  const auto path = folder.path() / "file";
  EXPECT_FALSE(read_elf_file(path));
  std::ofstream(path) << "#!/bin/sh\n";
  EXPECT_FALSE(read_elf_file(path));
  const std::string bytes = tests::read_file("/bin/sh");
  std::ofstream(path, std::ios::binary) << bytes.substr(0, 70);
  EXPECT_FALSE(read_elf_file(path));
  std::ofstream(path, std::ios::binary) << bytes.substr(0, 2000);
  const auto cut = read_elf_file(path);
  EXPECT_TRUE(!cut || cut->needed.empty());
}

TEST(ElfFile, LoadsOnTheOldestSystemWithItsLibrariesAndVersionsOnly) {
  const ElfFile old{"/lib64/ld-linux-x86-64.so.2",
                    {"libc.so.6", "libstdc++.so.6"},
                    {"GLIBC_2.2.5", "GLIBC_2.31", "GLIBCXX_3.4.28"}};
  EXPECT_TRUE(loads_on_oldest(old));
  EXPECT_TRUE(loads_on_oldest({}));  // static

  ElfFile other = old;
  other.versions.emplace_back("GLIBC_2.34");
  EXPECT_FALSE(loads_on_oldest(other));
  other = old;
  other.versions.emplace_back("GLIBC_ABI_DT_RELR");
  EXPECT_FALSE(loads_on_oldest(other));
  other = old;
  other.needed.emplace_back("libssl.so.3");
  EXPECT_FALSE(loads_on_oldest(other));
}

}  // namespace
}  // namespace cls::cli
