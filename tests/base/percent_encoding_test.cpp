// Paths in URLs.
#include "base/text/percent_encoding.h"

#include <gtest/gtest.h>

namespace cls::base {
namespace {

TEST(PercentEncoding, KeepsUnreservedCharactersAndSlashes) {
  EXPECT_EQ(percent_encoded("/runs/a-b_c.d~1/"), "/runs/a-b_c.d~1/");
}

TEST(PercentEncoding, ReplacesEverythingElse) {
  EXPECT_EQ(percent_encoded("a b%(c)#?\xc3\xa9"), "a%20b%25%28c%29%23%3F%C3%A9");
}

}  // namespace
}  // namespace cls::base
