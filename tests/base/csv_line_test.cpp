// Cells of lines, quoted or not.
#include "base/text/csv_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cls::base {
namespace {

using testing::ElementsAre;

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells = {"old"};
  split_csv_line(line, cells);
  return cells;
}

TEST(CsvLine, HasACellMoreThanCommas) {
  EXPECT_THAT(cells_of("a,b,,c"), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(cells_of(""), ElementsAre(""));
  EXPECT_THAT(cells_of("a,"), ElementsAre("a", ""));
  EXPECT_THAT(cells_of("a,b\r"), ElementsAre("a", "b"));
}

TEST(CsvLine, KeepsCommasInQuotationMarks) {
  EXPECT_THAT(cells_of("1,\"a,b\",2"), ElementsAre("1", "a,b", "2"));
  EXPECT_THAT(cells_of("\"a\""), ElementsAre("a"));
  EXPECT_THAT(cells_of("\"\",x"), ElementsAre("", "x"));
  EXPECT_THAT(cells_of("\"a\\\"b\",x"), ElementsAre("a\\\"b", "x"));
}

TEST(CsvLine, TakesLoneQuotationMarksAsText) {
  EXPECT_THAT(cells_of("\"a,b"), ElementsAre("\"a", "b"));
  EXPECT_THAT(cells_of("\""), ElementsAre("\""));
  EXPECT_THAT(cells_of("a\"b,c"), ElementsAre("a\"b", "c"));
}

}  // namespace
}  // namespace cls::base
