// Mistakes in JSON files are told with the line they are in.
#include "base/text/json_text.h"

#include <gtest/gtest.h>

namespace cls::base {
namespace {

JsonText document() {
  return *JsonText::parse("script.json",
                          "{\n"                                     // 1
                          "  // a comment with \"quotes\" and {\n"  // 2
                          "  \"name\": \"a \\\" , b\",\n"           // 3
                          "  \"list\": [1, {\"x\": [ ]},\n"         // 4
                          "    /* , */ {\"deep\":\n"                // 5
                          "      {\"a/b\": true}}]\n"               // 6
                          "}\n");
}

TEST(JsonText, FindsTheLineOfAPlace) {
  const JsonText text = document();
  EXPECT_EQ(text.line_of({}), 1);
  EXPECT_EQ(text.line_of(JsonPlace() / "name"), 3);
  EXPECT_EQ(text.line_of(JsonPlace() / "list"), 4);
  EXPECT_EQ(text.line_of(JsonPlace() / "list" / 2), 5);
  EXPECT_EQ(text.line_of(JsonPlace() / "list" / 2 / "deep" / "a/b"), 6);
}

TEST(JsonText, ErrorsNameFileLineAndPlace) {
  const JsonText text = document();
  const JsonValue flag = JsonValue(text)["list"][2]["deep"]["a/b"];
  EXPECT_EQ(flag.number().error().message,
            "script.json:6: /list/2/deep/a~1b: must be a number, not true");
}

TEST(JsonText, SyntaxErrorsNameLineAndColumn) {
  const auto bad = JsonText::parse("script.json", "{\n  \"a\": 1\n  \"b\": 2\n}\n");
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().message.rfind("script.json:3:5: syntax error", 0), 0u)
      << bad.error().message;
}

TEST(JsonText, FilesThatAreNotThereAreTold) {
  EXPECT_EQ(JsonText::read("/nowhere/a.json").error().message,
            "/nowhere/a.json: No such file or directory");
}

TEST(JsonValue, UnknownKeysSuggestTheNearest) {
  const JsonText text = document();
  EXPECT_EQ(JsonValue(text).object_of({"names", "list"}).error().message,
            "script.json:3: /name: unknown key 'name'; did you mean 'names'?");
  EXPECT_TRUE(JsonValue(text).object_of({"name", "list", "more"}));
}

TEST(JsonValue, NumbersHaveTheirRanges) {
  const JsonText text = document();
  const JsonValue one = JsonValue(text)["list"][0];
  EXPECT_EQ(*one.integer(1, 5), 1);
  EXPECT_EQ(one.integer(2, 5).error().message, "script.json:4: /list/0: 1 is not within 2 to 5");
}

}  // namespace
}  // namespace cls::base
