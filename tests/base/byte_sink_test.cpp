// Output files: contents and errors.
#include "base/io/byte_sink.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "base/io/background_sink.h"
#include "base/io/occupied_path.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::base {
namespace {

TEST(FileSink, WritesAllBytes) {
  const tests::TemporaryFolder folder;
  const auto path = folder.path() / "a.log";
  std::string expected;

  {
    auto sink = FileSink::create(path.string());
    ASSERT_TRUE(sink);
    for (int i = 0; i < 3000; ++i) {
      const std::string line = "line " + std::to_string(i) + std::string(50, '.') + "\n";
      expected += line;
      (*sink)->write(line);
    }
    EXPECT_TRUE((*sink)->close());
    EXPECT_TRUE((*sink)->close());
  }

  EXPECT_EQ(tests::read_file(path), expected);
}

TEST(FileSink, ReportsFileThatCannotBeCreated) {
  const auto sink = FileSink::create("/nonexistent-folder/game.rcg");
  ASSERT_FALSE(sink);
  EXPECT_EQ(sink.error().message,
            "cannot create '/nonexistent-folder/game.rcg': No such file or directory");
}

TEST(FileSink, ReportsFullDiskOnClose) {
  auto sink = FileSink::create("/dev/full");
  ASSERT_TRUE(sink);
  (*sink)->write("x");
  const auto closed = (*sink)->close();
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().message, "cannot write '/dev/full': No space left on device");
}

TEST(BackgroundSink, WritesAllBytesInOrder) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder.path() / "a.log.gz").string();
  auto sink = create_log_file(path, 1);
  ASSERT_TRUE(sink);

  std::string expected;
  for (int i = 0; i < 200'000; ++i) {
    const std::string line = "line " + std::to_string(i * 7919) + "\n";
    expected += line;
    (*sink)->write(line);
  }

  EXPECT_TRUE((*sink)->close());
  EXPECT_TRUE((*sink)->close());
  EXPECT_EQ(tests::read_file(path), expected);
}

TEST(BackgroundSink, ReportsFullDiskOnClose) {
  auto sink = create_log_file("/dev/full", 1);
  ASSERT_TRUE(sink);
  (*sink)->write("x");
  const auto closed = (*sink)->close();
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().message, "cannot write '/dev/full': No space left on device");
}

TEST(OccupiedPath, NamesContentsOfFolder) {
  const tests::TemporaryFolder folder;
  EXPECT_EQ(contents_of(folder.path()), "");
  EXPECT_EQ(contents_of(folder.path() / "missing"), "");
  for (const char* name : {"b", "a"}) std::ofstream(folder.path() / name) << name;
  EXPECT_EQ(contents_of(folder.path()), "a and b");
  for (const char* name : {"c", "d"}) std::ofstream(folder.path() / name) << name;
  EXPECT_EQ(contents_of(folder.path()), "a, b and 2 more");
}

TEST(OccupiedPath, RenamesToFreeName) {
  const tests::TemporaryFolder folder;
  const auto path = folder.path() / "x";

  for (const char* expected : {"x.old", "x.old2", "x.old3"}) {
    std::ofstream(path) << expected;
    const auto renamed = set_aside(path);
    ASSERT_TRUE(renamed);
    EXPECT_EQ(renamed->filename(), expected);
    EXPECT_EQ(tests::read_file(*renamed), expected);
  }
}

TEST(OccupiedPath, RenamesRegularFilesFoldersAndLinksOnly) {
  const tests::TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto renamed = set_aside(pipe);
  ASSERT_FALSE(renamed);
  EXPECT_EQ(renamed.error().message, "cannot rename " + pipe.string() + ": not a regular file");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

// A name that only exists() does not see is taken all the same.
TEST(OccupiedPath, ReplacesNoDanglingLink) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder.path() / "x") << "kept";
  std::filesystem::create_symlink("nowhere", folder.path() / "x.old");
  const auto renamed = set_aside(folder.path() / "x");
  ASSERT_TRUE(renamed);
  EXPECT_EQ(renamed->filename(), "x.old2");
}

}  // namespace
}  // namespace cls::base
