// Reasons why matches end.
#include "soccer/end_reason.h"

#include <gtest/gtest.h>

namespace cls::soccer {
namespace {

TEST(EndReason, RowsStandInTheOrderOfTheEnumAndNamesParse) {
  for (const EndReasonRow& row : end_reasons()) {
    EXPECT_EQ(&row_of(row.reason), &row);
    EXPECT_EQ(parse_end_reason(name(row.reason)), row.reason);
  }
  EXPECT_EQ(end_reasons().back().reason, EndReason::kInterrupted);
  EXPECT_EQ(name(EndReason::kTimedOut), "timed_out");
  EXPECT_FALSE(parse_end_reason("unknown"));
}

}  // namespace
}  // namespace cls::soccer
