// Sizes with units.
#include "base/text/byte_size.h"

#include <gtest/gtest.h>

namespace cls::base {
namespace {

TEST(ByteSize, ParsesWholeNumbersWithUnit) {
  EXPECT_EQ(parse_byte_size("1K"), 1024U);
  EXPECT_EQ(parse_byte_size("512M"), 512ULL << 20);
  EXPECT_EQ(parse_byte_size("2g"), 2ULL << 30);
  EXPECT_EQ(parse_byte_size("3T"), 3ULL << 40);
}

TEST(ByteSize, RefusesAnythingElse) {
  for (const char* text : {"", "M", "0M", "512", "-1M", "+1M", "1.5G", "2GB", "2 G", "1e3M", "2X",
                           "99999999999T", "99999999999999999999M"}) {
    EXPECT_FALSE(parse_byte_size(text)) << text;
  }
}

TEST(ByteSize, FormatsInTheLargestUnitThatDivides) {
  for (const char* text : {"1K", "1536K", "512M", "2G", "4T", "5000T"}) {
    EXPECT_EQ(byte_size_text(*parse_byte_size(text)), text);
  }
  EXPECT_EQ(byte_size_text(*parse_byte_size("1024M")), "1G");
}

}  // namespace
}  // namespace cls::base
