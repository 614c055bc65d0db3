// Words in texts.
#include "base/text/replace_all.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace cls::base
