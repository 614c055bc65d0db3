// The rules applied to the whole source tree.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/idioms.h"
#include "tests/architecture/rules.h"
#include "tests/architecture/source_files.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

bool is_source(const fs::path& path) {
  static const std::set<std::string> extensions = {".h", ".cpp", ".inc", ".hpp", ".cc", ".c"};
  return extensions.count(path.extension().string()) != 0;
}

/// All C++ files.
std::vector<SourceFile> read_tree() {
  std::vector<SourceFile> files;
  for (const fs::path& file : source_files()) {
    if (!is_source(file)) continue;
    files.push_back({fs::relative(file, source_folder()).generic_string(), read_file(file)});
  }
  return files;
}

const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> files = read_tree();
  return files;
}

template <typename Rule>
std::string violations_of(Rule rule) {
  std::vector<Violation> all;
  for (const SourceFile& file : tree()) {
    for (Violation& violation : rule(file)) all.push_back(std::move(violation));
  }
  return to_text(all);
}

TEST(SourceTree, IsReadCompletely) {
  std::map<std::string, int> count;
  for (const SourceFile& file : tree()) ++count[library_of(file.path)];
  for (const char* folder : {"soccer", "cli", "tests"}) EXPECT_GE(count[folder], 5) << folder;
  const auto self = std::find_if(tree().begin(), tree().end(), [](const SourceFile& file) {
    return file.path == "tests/architecture/source_tree_test.cpp";
  });
  ASSERT_NE(self, tree().end());
  EXPECT_GE(includes_of(self->text).size(), 9u);
}

// A link is nothing that the project needs; one that a program left behind leads out of a clone.
TEST(SourceTree, HasNoSymbolicLinks) {
  for (const fs::path& link : links_of_project(source_folder())) {
    ADD_FAILURE() << link << " leads to " << fs::read_symlink(link);
  }
}

TEST(SourceTree, IncludesReferToLowerFolders) { EXPECT_EQ(violations_of(check_includes), ""); }

TEST(SourceTree, IncludedFilesExist) {
  std::string absent;
  for (const SourceFile& file : tree()) {
    for (const Include& include : includes_of(file.text)) {
      const bool generated = include.path.find(".pb.h") != std::string::npos;
      const bool exists = fs::exists(source_folder() / include.path);
      if (include.quoted && !generated && !exists) absent += file.path + ": " + include.path + "\n";
    }
  }
  EXPECT_EQ(absent, "");
}

TEST(SourceTree, FoldersIncludeNoForbiddenHeaders) {
  EXPECT_EQ(violations_of(check_forbidden_headers), "");
}

TEST(SourceTree, CodeIsIndependentOfCpuLibraryAndClock) {
  EXPECT_EQ(violations_of(check_determinism), "");
}

TEST(SourceTree, FilesAndFunctionsHaveLimitedLength) { EXPECT_EQ(violations_of(check_shape), ""); }

TEST(SourceTree, UsesTheIdiomsOfTheTree) { EXPECT_EQ(violations_of(check_idioms), ""); }

TEST(SourceTree, DeclaresNothingThatIsUnused) {
  EXPECT_EQ(to_text(check_unused_declarations(tree())), "");
}

TEST(SourceTree, BoostProcessIsIncludedOnce) {
  EXPECT_EQ(to_text(check_process_wrapper(tree())), "");
}

}  // namespace
}  // namespace cls::tests
