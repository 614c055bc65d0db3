// Words, lines and white space in texts.
#include "base/text/replace_all.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/lines.h"
#include "base/text/trimmed.h"

namespace cls::base {
namespace {

TEST(ReplaceAll, ReplacesEachMark) {
  std::string text = "@N@, @N@ and @M@";
  replace_all(text, "@N@", "one");
  EXPECT_EQ(text, "one, one and @M@");
}

TEST(ReplaceAll, DoesNotSearchInTheValue) {
  std::string text = "xx";
  replace_all(text, "x", "xx");
  EXPECT_EQ(text, "xxxx");
}

TEST(Lines, EndAtLineFeedsAndAtTheEnd) {
  using testing::ElementsAre;
  EXPECT_THAT(lines_of(""), ElementsAre());
  EXPECT_THAT(lines_of("a"), ElementsAre("a"));
  EXPECT_THAT(lines_of("a\n\nb\n"), ElementsAre("a", "", "b"));
  EXPECT_EQ(first_line("a b\nc"), "a b");
}

TEST(Trimmed, LacksWhiteSpaceAtBothEnds) {
  EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
  EXPECT_EQ(trimmed("\n "), "");
  EXPECT_EQ(trimmed("/a/", "/"), "a");
}

}  // namespace
}  // namespace cls::base
