// Errors in JSON files name their line.
#include "base/text/json_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cls::base {
namespace {

JsonDocument document() {
  return *JsonDocument::parse("script.json",
                              "{\n"                                     // 1
                              "  // a comment with \"quotes\" and {\n"  // 2
                              "  \"name\": \"a \\\" , b\",\n"           // 3
                              "  \"list\": [1, {\"x\": [ ]},\n"         // 4
                              "    /* , */ {\"deep\":\n"                // 5
                              "      {\"a/b\": true}}]\n"               // 6
                              "}\n");
}

TEST(JsonDocument, ReportsNumbersThatAreTooLarge) {
  const auto read = JsonDocument::parse("drill.json", "{\n  \"x\": 1,\n  \"y\": -1e999\n}");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "drill.json:3: the number -1e999 is too large");
}

TEST(JsonDocument, FindsLineOfPointer) {
  const JsonDocument text = document();
  EXPECT_EQ(text.line_of({}), 1);
  EXPECT_EQ(text.line_of(JsonPointer() / "name"), 3);
  EXPECT_EQ(text.line_of(JsonPointer() / "list"), 4);
  EXPECT_EQ(text.line_of(JsonPointer() / "list" / 2), 5);
  EXPECT_EQ(text.line_of(JsonPointer() / "list" / 2 / "deep" / "a/b"), 6);
}

// The parser ends a comment there, too.
TEST(JsonDocument, FindsLinesAfterCommentsThatEndEarly) {
  using namespace std::string_literals;

  for (const std::string& comment : {"//\r"s, "// x\0"s, "/*/ \n*/"s, "/**/"s}) {
    const auto read =
        JsonDocument::parse("script.json", "{\"a\": " + comment + "[1],\n\"b\": 2} //");
    ASSERT_TRUE(read) << comment;
    const int lines = comment.find('\n') == std::string::npos ? 0 : 1;
    EXPECT_EQ(read->line_of(JsonPointer() / "a"), 1 + lines) << comment;
    EXPECT_EQ(read->line_of(JsonPointer() / "b"), 2 + lines) << comment;
    EXPECT_EQ(read->line_of(JsonPointer() / "c"), 1) << comment;
  }
}

TEST(JsonDocument, ErrorsNameFileLineAndPointer) {
  const JsonDocument text = document();
  const JsonValue flag = JsonValue(text)["list"][2]["deep"]["a/b"];
  EXPECT_EQ(flag.number().error().message,
            "script.json:6: /list/2/deep/a~1b: must be a number, not true");
}

TEST(JsonDocument, SyntaxErrorsNameLineAndColumn) {
  const auto bad = JsonDocument::parse("script.json", "{\n  \"a\": 1\n  \"b\": 2\n}\n");
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().message, testing::StartsWith("script.json:3:5: syntax error"));
}

TEST(JsonDocument, ReportsMissingFile) {
  EXPECT_EQ(JsonDocument::read("/nowhere/a.json").error().message,
            "/nowhere/a.json: No such file or directory");
}

TEST(JsonValue, SuggestsSimilarKeyForUnknownKey) {
  const JsonDocument text = document();
  EXPECT_EQ(JsonValue(text).expect_keys({"names", "list"}).error().message,
            "script.json:3: /name: unknown key 'name'; did you mean 'names'?");
  EXPECT_TRUE(JsonValue(text).expect_keys({"name", "list", "more"}));
}

TEST(JsonValue, ChecksRangesOfNumbers) {
  const JsonDocument text = document();
  const JsonValue one = JsonValue(text)["list"][0];
  EXPECT_EQ(*one.integer(1, 5), 1);
  EXPECT_EQ(one.integer(2, 5).error().message, "script.json:4: /list/0: 1 is not within 2 to 5");
}

}  // namespace
}  // namespace cls::base
