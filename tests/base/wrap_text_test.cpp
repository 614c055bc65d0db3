// Line wrapping.
#include "base/text/wrap_text.h"

#include <gtest/gtest.h>

#include <string>

namespace cls::base {
namespace {

TEST(WrapText, BreaksAtLastSpaceThatFits) {
  EXPECT_EQ(wrap_text("one two three four", 9), "one two\nthree\nfour");
  EXPECT_EQ(wrap_text("one two three four", 7), "one two\nthree\nfour");
  EXPECT_EQ(wrap_text("one two three four", 80), "one two three four");
  EXPECT_EQ(wrap_text("one two three four", 10), "one two\nthree four");
}

TEST(WrapText, PreservesLongWordsAndExistingLines) {
  EXPECT_EQ(wrap_text("a incomprehensible b c", 5), "a\nincomprehensible\nb c");
  EXPECT_EQ(wrap_text("one\ntwo three", 8), "one\ntwo\nthree");
  EXPECT_EQ(wrap_text("one two\nthree", 7), "one two\nthree");
  EXPECT_EQ(wrap_text("", 5), "");
}

TEST(WrapText, ContinuesAtIndent) {
  EXPECT_EQ(wrap_text("one two three", 9, 2), "one two\n  three");
  EXPECT_EQ(wrap_text("one two three", 80, 28), "one two three");
  EXPECT_EQ(wrap_text("one two", 3, 28), "one\n" + std::string(28, ' ') + "two");
}

}  // namespace
}  // namespace cls::base
