// Output files: contents and errors.
#include "base/io/byte_sink.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace cls::base
