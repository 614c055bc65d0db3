// Lines of limited width.
#include "base/text/wrapped_text.h"

#include <gtest/gtest.h>

namespace cls::base {
namespace {

TEST(WrappedText, BreaksAtTheLastBlankThatFits) {
  EXPECT_EQ(wrapped("one two three four", 9), "one two\nthree\nfour");
  EXPECT_EQ(wrapped("one two three four", 7), "one two\nthree\nfour");
  EXPECT_EQ(wrapped("one two three four", 80), "one two three four");
  EXPECT_EQ(wrapped("one two three four", 10), "one two\nthree four");
}

TEST(WrappedText, KeepsLongWordsAndLinesThatAreThere) {
  EXPECT_EQ(wrapped("a incomprehensible b c", 5), "a\nincomprehensible\nb c");
  EXPECT_EQ(wrapped("one\ntwo three", 8), "one\ntwo\nthree");
  EXPECT_EQ(wrapped("one two\nthree", 7), "one two\nthree");
  EXPECT_EQ(wrapped("", 5), "");
}

}  // namespace
}  // namespace cls::base
