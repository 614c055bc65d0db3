// Tests that docs name as the proof of a promise exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_files.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

/// "Suite.Name" of all tests in C++.
std::set<std::string> names_of_tests() {
  static const std::regex kTest(R"(\bTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const fs::path& file : source_files()) {
    if (file.extension() != ".cpp") continue;
    const std::string text = read_file(file);
    for (std::sregex_iterator match(text.begin(), text.end(), kTest), end; match != end; ++match) {
      names.insert((*match)[1].str() + "." + (*match)[2].str());
    }
  }
  return names;
}

/// `Suite.Name` and `Suite.*` in a page. Names of tests begin with a capital letter in both parts.
std::vector<std::string> cited_tests(const std::string& page) {
  static const std::regex kCited("`([A-Z]\\w+\\.(?:[A-Z]\\w+|\\*))`");
  std::vector<std::string> cited;
  for (std::sregex_iterator match(page.begin(), page.end(), kCited), end; match != end; ++match) {
    cited.push_back((*match)[1]);
  }
  return cited;
}

bool exists(const std::string& cited, const std::set<std::string>& names) {
  if (!cited.ends_with(".*")) return names.contains(cited);
  const std::string suite = cited.substr(0, cited.size() - 1);
  const auto first = names.lower_bound(suite);
  return first != names.end() && first->starts_with(suite);
}

TEST(Promises, NameExistingTests) {
  const std::set<std::string> names = names_of_tests();
  for (const char* page : {"docs/reliability.md", "docs/security.md"}) {
    const auto cited = cited_tests(read_file(source_folder() / page));
    EXPECT_GT(cited.size(), 10U) << page;
    for (const std::string& test : cited) {
      EXPECT_TRUE(exists(test, names)) << page << ": there is no test " << test;
    }
  }
}

TEST(Promises, AreFoundInPages) {
  EXPECT_EQ(cited_tests("| a | `One.HoldsIt`, `Two.*` | `file.cpp`, `cls.match/1` |"),
            (std::vector<std::string>{"One.HoldsIt", "Two.*"}));
  EXPECT_FALSE(exists("One.HoldsIt", {"One.HoldsThat"}));
  EXPECT_FALSE(exists("One.*", {"OneMore.HoldsIt"}));
}

}  // namespace
}  // namespace cls::tests
