// The reader of recorded message streams.
#include "tests/support/message_stream.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace cls::tests {
namespace {

TEST(MessageStream, SplitsByLengthPrefix) {
  const std::string stream(
      "\x02"
      "ab"
      "\x00"
      "\x01"
      "c",
      6);
  EXPECT_EQ(split_messages(stream), (std::vector<std::string>{"ab", "", "c"}));
}

TEST(MessageStream, ReadsMultiByteLengths) {
  const std::string message(300, 'x');
  EXPECT_EQ(split_messages("\xac\x02" + message), std::vector<std::string>{message});
}

TEST(MessageStream, RejectsTruncatedStream) {
  EXPECT_THROW(split_messages("\x03"
                              "ab"),
               std::runtime_error);
  EXPECT_THROW(split_messages("\x80"), std::runtime_error);
  EXPECT_THROW(split_messages("\x80\x80\x80\x80\x80\x01"), std::runtime_error);
}

TEST(MessageStream, IsEmptyWithoutBytes) { EXPECT_TRUE(split_messages("").empty()); }

}  // namespace
}  // namespace cls::tests
