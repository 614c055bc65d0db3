// Build files follow the architecture: dependencies, floating point flags, packages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/architecture/rules.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

/// The first group of each match of `pattern` in `text`.
std::set<std::string> all_matches(const std::string& text, const std::string& pattern) {
  std::set<std::string> found;
  const std::regex regex(pattern);
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
    found.insert((*at)[1]);
  }
  return found;
}

/// The library of a library: "match" for cls_match.
std::string library_of_target(const std::string& name) {
  if (name == "proto_generated") return "proto";
  for (std::string library : known_libraries()) {
    const std::string path = library;
    std::replace_if(
        library.begin(), library.end(), [](char c) { return c == '/' || c == '-'; }, '_');
    if (library == name) return path;
  }
  return name;
}

TEST(BuildFiles, LinkListsContainLowerLibrariesOnly) {
  int seen = 0;
  for (const std::string& folder : known_libraries()) {
    const fs::path path = source_folder() / folder / "CMakeLists.txt";
    if (folder == "tests" || !fs::exists(path)) continue;
    ++seen;
    for (const std::string& name : all_matches(read_file(path), R"(^\s+cls_(\w+)\)?\s*$)")) {
      const std::string target = library_of_target(name);
      EXPECT_EQ(allowed_libraries(folder).count(target), 1u) << folder << " links " << target;
    }
  }
  EXPECT_GE(seen, 14);
}

TEST(BuildFiles, DisableFloatingPointContraction) {
  const std::string commands = read_file(fs::path(CLS_BUILD_DIR) / "compile_commands.json");
  const std::regex command("\"command\": \"[^\n]*");
  int seen = 0;
  for (std::sregex_iterator at(commands.begin(), commands.end(), command), end; at != end; ++at) {
    const std::string line = at->str();
    ++seen;
    EXPECT_THAT(line, HasSubstr("-ffp-contract=off")) << line;
    for (const char* flag : {"-ffast-math", "-Ofast", "-march=", "-mfma", "-funsafe"}) {
      EXPECT_THAT(line, Not(HasSubstr(flag))) << line;
    }
    EXPECT_THAT(line, Not(HasSubstr("-DNDEBUG"))) << "assertions must stay enabled: " << line;
  }
  EXPECT_GE(seen, 10);
}

TEST(BuildFiles, BootstrapInstallsPackagesOfCMake) {
  const std::string modules = read_file(source_folder() / "cmake/Dependencies.cmake");
  std::set<std::string> wanted = all_matches(modules, R"(\bcls_need\(\w+ ([a-z0-9+.-]+))");
  wanted.merge(all_matches(modules, "install ([a-z0-9+.-]+) "));
  wanted.erase("libc6-dev");  // dependency of g++
  EXPECT_EQ(wanted.count("libsleef-dev"), 1u);
  const std::string bootstrap = read_file(source_folder() / "bootstrap");
  EXPECT_EQ(wanted, all_matches(bootstrap, R"(\n  ((?:lib|zlib|nlohmann)[a-z0-9+.-]+))"));
}

// `pip install ./python` after `./bootstrap match` finds the engine of cls_gym.
TEST(BuildFiles, BootstrapBuildsWhatPythonNeeds) {
  const std::string bootstrap = read_file(source_folder() / "bootstrap");
  for (const char* command : {"\n  match)\n", "\n  python)\n"}) {
    const std::size_t start = bootstrap.find(command);
    ASSERT_NE(start, std::string::npos) << command;
    EXPECT_THAT(bootstrap.substr(start, bootstrap.find(";;", start) - start),
                HasSubstr("build OFF cls cls_python_package cls_training_shared\n"));
  }
}

TEST(BuildFiles, PythonPackageHasVersionOfProject) {
  const auto project = all_matches(read_file(source_folder() / "CMakeLists.txt"),
                                   R"(project\(cls VERSION ([0-9.]+))");
  const auto package = all_matches(read_file(source_folder() / "python/pyproject.toml"),
                                   R"(\nversion = .([0-9.]+))");
  ASSERT_EQ(project.size(), 1u);
  EXPECT_EQ(package, project);
}

TEST(BuildFiles, TopLevelFileIsShort) {
  const auto lines = lines_of(read_file(source_folder() / "CMakeLists.txt"));
  EXPECT_GE(lines.size(), 10u);
  EXPECT_LE(lines.size(), 120u);
}

}  // namespace
}  // namespace cls::tests
