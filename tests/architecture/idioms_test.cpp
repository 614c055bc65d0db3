// The idioms that are forbidden, and the search for declarations that nothing uses.
#include "tests/architecture/idioms.h"

#include <gtest/gtest.h>

namespace cls::tests {
namespace {

TEST(Idioms, AreReportedWithTheirReplacement) {
  EXPECT_EQ(to_text(check_idioms({"cli/a.cpp", "\nif (text.rfind(start, 0) == 0) {}\n"})),
            "cli/a.cpp:2: rfind(start, 0) == 0: use starts_with()\n");
  for (const char* line :
       {"int n = std::stoi(text);", "rows[2].shown_as = \"x\";", "side == Side::kLeft ? 0 : 1",
        "#include <nlohmann/json.hpp>", "std::cout << 1;", "void* p = NULL;", "x = (attempts)[i];",
        "auto f = std::bind(g, 1);", "std::find(all.begin(), all.end(), x)"}) {
    EXPECT_EQ(check_idioms({"cli/a.cpp", line}).size(), 1u) << line;
  }
}

TEST(Idioms, AreAllowedInCommentsAndInTheirOwnPlace) {
  EXPECT_EQ(to_text(check_idioms({"cli/a.cpp", "// std::stoi(text) would throw\n"})), "");
  EXPECT_EQ(to_text(check_idioms({"base/text/json.cpp", "#include <nlohmann/json.hpp>\n"})), "");
  EXPECT_EQ(to_text(check_idioms({"cli/a.cpp", "values(attempts)[i]; call((x)[1]);\n"})),
            "cli/a.cpp:1: ((x)[: use the name without parentheses\n");
}

TEST(UnusedDeclarations, AreReported) {
  const std::vector<SourceFile> files = {
      {"cli/a.h", "inline constexpr int kLimit = 3;\nint count(int x);\nstruct Lonely {\n};\n"},
      {"cli/a.cpp", "// kLimit count\nint count(int x) {\n  return x;\n}\n"}};

  EXPECT_EQ(to_text(check_unused_declarations(files)),
            "cli/a.h:3: Lonely: nothing uses it; delete it\n"
            "cli/a.h:2: count: nothing uses it; delete it\n"
            "cli/a.h:1: kLimit: nothing uses it; delete it\n");
}

TEST(UnusedDeclarations, IncludeNoneThatAnotherLineNames) {
  const std::vector<SourceFile> files = {
      {"cli/a.h", "inline constexpr int kLimit = 3;\nint count(int x);\nstruct Pair {\n};\n"},
      {"cli/b.cpp", "int main() {\n  return count(kLimit) + Pair().first;\n}\n"}};

  EXPECT_EQ(to_text(check_unused_declarations(files)), "");
}

}  // namespace
}  // namespace cls::tests
