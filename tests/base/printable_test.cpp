// What may be printed, in texts and in JSON.
#include "base/text/printable.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace cls::base {
namespace {

TEST(Printable, ReplacesControlsAndInvalidBytes) {
  EXPECT_EQ(printable("\x1b[2J\x1b]0;x\a\ttab\r\n\x7f"), "?[2J?]0;x? tab???");
  EXPECT_EQ(printable("\xff\xc3\xa9 \xed\xa0\x80"), "?\xc3\xa9 ???");
  EXPECT_EQ(printable("\xf0\x9f\x98\x80\xf4\x90\x80\x80\xe0\x80\x80\xc0\xaf"),
            "\xf0\x9f\x98\x80?????????");
  EXPECT_EQ(printable("\xe2\x82"), "??");
}

TEST(Printable, ReplacesControlsBeyondAscii) {
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "?2J")
      << "C1";
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "txet"),
            "?txet")
      << "right-to-left override";
  EXPECT_EQ(printable("\xef\xbb\xbf"
                      "bom"),
            "?bom");

  EXPECT_EQ(printable("a\xe2\x80\x8b"
                      "b"),
            "a?b")
      << "zero width space";
  EXPECT_EQ(printable("\xf3\xa0\x80\x81"), "?") << "tag";
  EXPECT_EQ(printable("\xc2\xa0\xe2\x80\x93\xe4\xb8\xad"), "\xc2\xa0\xe2\x80\x93\xe4\xb8\xad");
}

TEST(PrintableLines, RetainsLineFeeds) {
  EXPECT_EQ(printable_lines("a\x1b\nb\n"), "a?\nb\n");
  EXPECT_EQ(printable_lines("a"), "a");
  EXPECT_EQ(printable_lines("\n\n"), "\n\n");
}

TEST(PrintableJson, EscapesAndStaysTheSameDocument) {
  const nlohmann::json document = {
      {"name", "\x1b[2J\x7f\xc2\x9b\xe2\x80\xae\xf3\xa0\x80\x81\xc3\xa9"}};
  const std::string text = printable_json(document.dump(2) + "\n");
  EXPECT_EQ(text, "{\n  \"name\": \"\\u001b[2J\\u007f\\u009b\\u202e\\udb40\\udc01\xc3\xa9\"\n}\n");
  EXPECT_EQ(nlohmann::json::parse(text), document);
}

}  // namespace
}  // namespace cls::base
