// Output of processes: repetitions, size limit, printable characters.
#include "process/output_log.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

using testing::HasSubstr;

class OutputLogTest : public testing::Test {
 protected:
  OutputLog open(std::size_t limit = 1 << 20) {
    return OutputLog(base::UniqueFd(::open(path().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666)),
                     limit);
  }
  std::filesystem::path path() const { return folder_.path() / "x.log"; }
  std::string written() const { return tests::read_file(path()); }

 private:
  tests::TemporaryFolder folder_;
};

TEST_F(OutputLogTest, JoinsLinesFromAnyChunks) {
  OutputLog log = open();
  for (const char* piece : {"on", "e\ntwo\r\n", "", "\nfour"}) log.add(piece);
  EXPECT_EQ(log.last_lines(), (std::vector<std::string>{"one", "two", "", "four"}));
  log.finish();
  EXPECT_EQ(written(), "one\ntwo\n\nfour\n");
}

// Some programs print a buffer of fixed size, with what is behind its text.
TEST_F(OutputLogTest, TrimsPadding) {
  OutputLog log = open();
  log.add("joined" + std::string(4000, '\0') + "\r\n");
  log.add("left   \n");
  EXPECT_EQ(log.last_lines(), (std::vector<std::string>{"joined", "left"}));
}

TEST_F(OutputLogTest, CollapsesRepeatedLines) {
  OutputLog log = open();
  log.add("start\n");
  for (int i = 0; i < 2310; ++i) log.add("cannot open formation.conf\n");
  log.add("go on\n");
  for (int i = 0; i < 3; ++i) log.add("again\n");
  log.finish();

  EXPECT_EQ(written(), "start\ncannot open formation.conf\n  ×2310\ngo on\nagain\n  ×3\n");
  EXPECT_EQ(log.last_lines(3),
            (std::vector<std::string>{"cannot open formation.conf ×2310", "go on", "again ×3"}));
}

TEST_F(OutputLogTest, StopsAtSizeLimitAndStoresLastLines) {
  OutputLog log = open(1000);
  for (int i = 1; i <= 5000; ++i) log.add("line " + std::to_string(i) + "\n");
  EXPECT_LE(written().size(), 1000U);

  log.finish();
  const std::string text = written();
  EXPECT_EQ(text.substr(0, 7), "line 1\n");
  EXPECT_LT(text.size(), 3000U);
  EXPECT_THAT(text, HasSubstr("\nline 5000\n"));
  EXPECT_EQ(log.last_lines().size(), OutputLog::kMaxLastLines);

  // Every line is either written or counted.
  const std::size_t mark = text.find("[size limit of this log: ");
  ASSERT_NE(mark, std::string::npos);
  const std::size_t left_out = std::stoul(text.substr(mark + 25));
  const auto lines_in = [](const std::string& part) {
    return static_cast<std::size_t>(std::count(part.begin(), part.end(), '\n'));
  };
  EXPECT_EQ(left_out + lines_in(text) - 1, 5000U);
}

TEST_F(OutputLogTest, TruncatesLongLines) {
  OutputLog log = open();
  for (int i = 0; i < 1000; ++i) log.add(std::string(1000, 'x'));
  log.add("\nshort\n");
  log.finish();
  EXPECT_EQ(written(), std::string(OutputLog::kMaxLineBytes, 'x') + "\nshort\n");
}

TEST_F(OutputLogTest, ReplacesUnprintableCharacters) {
  OutputLog log = open();
  log.add("\x1b[31mred\x1b[0m\ttab \xff\xc3\xa9 \xed\xa0\x80\n");
  EXPECT_EQ(log.last_lines(), (std::vector<std::string>{"?[31mred?[0m tab ?é ???"}));
}

TEST_F(OutputLogTest, ReportsFullDisk) {
  OutputLog log(base::UniqueFd(::open("/dev/full", O_WRONLY)), 1000);
  log.add("a\nb\n");
  log.finish();
  EXPECT_EQ(log.error(), ENOSPC);
  EXPECT_EQ(log.last_lines().size(), 2U);
}

TEST_F(OutputLogTest, CallsBackForEachLine) {
  std::vector<std::string> seen;
  OutputLog log(base::UniqueFd(), 0, [&](std::string_view line) { seen.emplace_back(line); });
  log.add("a\na\nb");
  EXPECT_EQ(seen, (std::vector<std::string>{"a", "a"}));
  log.finish();
  EXPECT_EQ(seen, (std::vector<std::string>{"a", "a", "b"}));
}

}  // namespace
}  // namespace cls::process
