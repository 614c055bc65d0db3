// Numbers for readers, and their middle.
#include "base/text/decimal_text.h"

#include <gtest/gtest.h>

#include "base/median.h"

namespace cls::base {
namespace {

TEST(DecimalText, HasNoTrailingZeros) {
  EXPECT_EQ(decimal_text(1.504, 2), "1.5");
  EXPECT_EQ(decimal_text(12.0, 2), "12");
  EXPECT_EQ(decimal_text(100.0, 0), "100");
  EXPECT_EQ(decimal_text(-0.001, 2), "0");
}

TEST(Median, IsTheMiddleValueTheHigherOfTwo) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0}), 4.0);
  EXPECT_EQ(median({}), 0.0);
}

}  // namespace
}  // namespace cls::base
