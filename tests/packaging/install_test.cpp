// cmake --install into an empty prefix, which is then moved: everything works from there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "base/text/json.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/python.h"
#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// One installed tree for all tests: `prefix` is not where it was installed.
class Installation : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const fs::path first = folder_->path() / "first";
    const CommandResult installed =
        run({"cmake", "--install", CLS_BUILD_DIR, "--prefix", first.string()});
    ASSERT_EQ(installed.exit_code, 0) << installed.out << installed.err;
    fs::rename(first, prefix());
  }
  static void TearDownTestSuite() { delete folder_; }

  static fs::path prefix() { return folder_->path() / "moved"; }

  // In an empty folder, with nothing of the build in the environment.
  static CommandResult run_there(const Words& words, const Words& environment = {}) {
    const fs::path work = folder_->path() / "work";
    fs::create_directories(work);
    return Command(words, environment, work).finish(std::chrono::seconds(120));
  }

 private:
  static inline TemporaryFolder* folder_ = nullptr;
};

TEST_F(Installation, PlaysAndTestsWithItsOwnData) {
  const std::string cls = prefix() / "bin/cls";
  const CommandResult match = run_there(
      {cls, "match", "mock", "mock", "--seed", "1", "--cycles", "20", "--dir", "match", "--json"});
  EXPECT_EQ(match.exit_code, 0) << match.err;
  EXPECT_EQ(base::Json::parse(match.out)["end_reason"], "finished");
  EXPECT_EQ(run_there({cls, "watch", "match", "--out", "page.html"}).exit_code, 0);
  EXPECT_EQ(run_there({cls, "test", "physics_dash"}).exit_code, 0);
  EXPECT_EQ(run_there({cls, "new", "python", "ada"}).exit_code, 0);
  EXPECT_EQ(run_there({cls, "help", "testing"}).exit_code, 0);
}

TEST_F(Installation, IsStrippedAndNamesNoFolderOfTheBuild) {
  const CommandResult sections = run_there({"readelf", "-S", "-d", prefix() / "bin/cls"});
  ASSERT_EQ(sections.exit_code, 0) << sections.err;
  EXPECT_THAT(sections.out, Not(HasSubstr(".debug_info")));
  EXPECT_THAT(sections.out, Not(HasSubstr(".symtab")));
  EXPECT_THAT(sections.out, Not(HasSubstr("RUNPATH")));
  for (const auto& entry : fs::recursive_directory_iterator(prefix() / "share")) {
    if (!entry.is_regular_file()) continue;
    EXPECT_THAT(read_file(entry.path()), Not(HasSubstr(CLS_BUILD_DIR))) << entry.path();
  }
}

TEST_F(Installation, HasManualCompletionsAndInterface) {
  for (const char* file :
       {"share/man/man1/cls.1", "share/man/man1/cls-match.1",
        "share/bash-completion/completions/cls", "share/zsh/site-functions/_cls",
        "share/fish/vendor_completions.d/cls.fish", "share/cls/proto/playmaker.proto",
        "share/doc/cls/examples/scenarios/golden.json", "share/doc/cls/README.md",
        "share/doc/cls/proto/playmaker.proto", "include/cls_training.h"}) {
    EXPECT_TRUE(fs::exists(prefix() / file)) << file;
  }
}

TEST_F(Installation, LinksOfItsPagesResolve) {
  const std::regex link(R"(\]\(([^)#:]+)[^)]*\))");
  int seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(prefix() / "share/doc/cls/docs")) {
    if (entry.path().extension() != ".md") continue;
    const std::string text = read_file(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
      const fs::path target = entry.path().parent_path() / (*at)[1].str();
      if ((*at)[1].str().starts_with("http")) continue;
      EXPECT_TRUE(fs::exists(target)) << entry.path() << ": " << target;
      ++seen;
    }
  }
  EXPECT_GE(seen, 30);
}

TEST_F(Installation, HasPythonPackagesThatFindTheirLibrary) {
  const std::string python = python_with_grpc();
  if (python.empty()) GTEST_SKIP() << "no Python with grpc";
  const Words environment = {"PYTHONPATH=" + (prefix() / "share/cls/python").string(),
                             "PYTHONDONTWRITEBYTECODE=1"};
  const CommandResult wire = run_there(
      {python, "-c", "from cls_playmaker import proto; print(proto.State().DESCRIPTOR.full_name)"},
      environment);
  EXPECT_EQ(wire.exit_code, 0) << wire.err;
  if (run_there({python, "-c", "import numpy"}).exit_code != 0) GTEST_SKIP() << "no numpy";
  if (CLS_SANITIZED) GTEST_SKIP() << "Python does not load a library with sanitizers";
  const CommandResult engine = run_there(
      {python, "-c",
       "from cls_gym._engine import catalog, library_path; print(library_path(), len(catalog()))"},
      environment);
  EXPECT_EQ(engine.exit_code, 0) << engine.err;
  EXPECT_THAT(engine.out, HasSubstr((prefix() / "share").string())) << engine.out;
}

TEST_F(Installation, HasACMakePackageOfTheTrainingLibrary) {
  if (CLS_SANITIZED) GTEST_SKIP() << "the library needs the sanitizers of this build";
  TemporaryFolder project;
  std::ofstream(project.path() / "CMakeLists.txt")
      << "cmake_minimum_required(VERSION 3.22)\nproject(consumer LANGUAGES CXX)\n"
         "find_package(cls_training 0.1 REQUIRED)\nadd_executable(consumer main.cpp)\n"
         "target_link_libraries(consumer PRIVATE cls::training)\n";
  std::ofstream(project.path() / "main.cpp")
      << "#include <cls_training.h>\n"
         "int main() { return cls_training_abi() == CLS_TRAINING_ABI ? 0 : 1; }\n";
  const std::string build = project.path() / "build";
  const CommandResult configured = run_there(
      {"cmake", "-S", project.path(), "-B", build, "-DCMAKE_PREFIX_PATH=" + prefix().string()});
  ASSERT_EQ(configured.exit_code, 0) << configured.out << configured.err;
  const CommandResult built = run_there({"cmake", "--build", build});
  ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
  EXPECT_EQ(run_there({build + "/consumer"}).exit_code, 0);
}

}  // namespace
}  // namespace cls::tests
