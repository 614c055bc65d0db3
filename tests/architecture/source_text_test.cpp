// Scanner of the architecture rules: comments, literals, includes, functions.
#include "tests/architecture/source_text.h"

#include <gtest/gtest.h>

namespace cls::tests {
namespace {

TEST(SourceText, BlanksCommentsAndPreservesLineNumbers) {
  EXPECT_EQ(without_comments("a; // b\nc; /* d\n e */ f;", Literals::kKeep),
            "a;     \nc;     \n      f;");
}

TEST(SourceText, BlanksLiteralsOnRequest) {
  EXPECT_EQ(without_comments("f(\"a // b\", 'c');", Literals::kKeep), "f(\"a // b\", 'c');");
  EXPECT_EQ(without_comments("f(\"a // b\", 'c');", Literals::kBlank), "f(\"      \", ' ');");
}

TEST(SourceText, HandlesEscapesRawStringsAndDigitSeparators) {
  EXPECT_EQ(without_comments(R"(x = "a\"b" + 1'000'000; // c)", Literals::kBlank),
            R"(x = "    " + 1'000'000;     )");
  EXPECT_EQ(without_comments("R\"x(a \" // )\" b)x\" + c", Literals::kBlank),
            "R\"x(           )x\" + c");
}

TEST(SourceText, FindsAllFormsOfIncludes) {
  const auto includes = includes_of(
      "// #include \"no\"\n#include \"a/b.h\"\n  #  include <c>  // d\n"
      "/* #include <e> */\nconst char* s = \"#include <f>\";\n");
  ASSERT_EQ(includes.size(), 2u);
  EXPECT_EQ(includes[0].path, "a/b.h");
  EXPECT_TRUE(includes[0].quoted);
  EXPECT_EQ(includes[0].line, 2);
  EXPECT_EQ(includes[1].path, "c");
  EXPECT_FALSE(includes[1].quoted);
}

TEST(SourceText, MeasuresFunctionsWithSignature) {
  const auto functions = functions_of(
      "namespace a {\n\n"
      "int f() {\n  return 1;\n}\n\n"
      "struct S {\n  int x() {\n    if (y) {\n    }\n  }\n};\n\n"
      "void long_name(int a,\n               int b) const {\n"
      "  if (a) {\n  }\n}\n\n"
      "constexpr int kTable[] = {\n  1,\n};\n"
      "}\n");
  ASSERT_EQ(functions.size(), 2u);
  EXPECT_EQ(functions[0].line, 3);
  EXPECT_EQ(functions[0].length, 3);
  EXPECT_EQ(functions[1].line, 14);
  EXPECT_EQ(functions[1].length, 5);
}

}  // namespace
}  // namespace cls::tests
