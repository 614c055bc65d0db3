// The folders that the sandbox of an external team has.
#include "match/programs/team_sandbox.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.h"

namespace cls::match {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Ne;

namespace fs = std::filesystem;

class TeamSandbox : public testing::Test {
 protected:
  TeamSandbox() {
    for (const char* name : {"team", "rivals/lib", "tools"}) fs::create_directories(path(name));
  }
  fs::path path(const std::string& name) const { return fs::canonical(folder_.path()) / name; }

 private:
  tests::TemporaryFolder folder_;
};

TEST_F(TeamSandbox, HasSystemAndOwnFolder) {
  const process::FileAccess files = team_files(path("team"), {path("match"), path("rivals")});
  EXPECT_THAT(files.readable, IsSupersetOf<fs::path>({"/usr", "/etc"}));
  EXPECT_THAT(files.writable, IsSupersetOf<fs::path>({path("team"), "/dev/null"}));
  for (const auto& folders : {files.readable, files.writable}) {
    EXPECT_THAT(folders, Each(AllOf(Ne("/"), Ne(path("")), Ne("/tmp"))));
  }
}

TEST_F(TeamSandbox, LeavesOutHiddenFoldersOfTheSystem) {
  const process::FileAccess files = team_files(path("team"), {"/usr/share/", "/dev/shm/runs"});
  EXPECT_THAT(files.readable, IsSupersetOf<fs::path>({"/usr/bin", "/usr/lib"}));
  EXPECT_THAT(files.readable, Each(AllOf(Ne("/usr"), Ne("/usr/share"))));
  EXPECT_THAT(files.writable, Each(Ne("/dev/shm")));
}

TEST_F(TeamSandbox, CoversHiddenFoldersInItsOwnWithNamespaces) {
  const std::vector<fs::path> hidden = {path("team/runs/1"), path("team"), path("rivals")};
  EXPECT_THAT(team_files(path("team"), hidden, true).covered, ElementsAre(path("team/runs/1")));
  EXPECT_THAT(team_files(path("team"), hidden, false).covered, IsEmpty());
}

TEST_F(TeamSandbox, OfAPlaymakerIsTheFolderOfItsScript) {
  EXPECT_EQ(playmaker_folder("python3 playmaker.py --port {port}"), fs::current_path());
  EXPECT_EQ(playmaker_folder("cd " + path("rivals").string() + " && ./run --port {port}"),
            path("rivals"));

  process::CommandPlan plan = process::shell_command("left Playmaker", "env");
  plan.environment = {{"PYTHONUNBUFFERED", "1"}};
  put_playmaker_in_sandbox(plan, path("team/run").string() + " --port {port}", {});
  EXPECT_EQ(plan.folder, fs::current_path());
  EXPECT_EQ(plan.environment.back().name, "PYTHONUNBUFFERED");
  if (!plan.files) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_THAT(plan.files->writable, Contains(path("team")));
  EXPECT_THAT(plan.files->writable, Each(Ne(fs::current_path())));
  EXPECT_THAT(plan.files->own, Contains(fs::current_path()));
}

TEST_F(TeamSandbox, ReadsFoldersOfPathsButNotAboveHome) {
  const std::string before = std::getenv("PATH");
  const std::string home = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
  ::setenv("HOME", path("").parent_path().c_str(), 1);
  ::setenv("PATH",
           (path("tools").string() + "::relative:" + path("").parent_path().string() +
            ":/tmp:" + path("rivals/lib").string())
               .c_str(),
           1);
  const process::FileAccess files = team_files(path("team"), {path("rivals")});
  ::setenv("PATH", before.c_str(), 1);
  ::setenv("HOME", home.c_str(), 1);

  EXPECT_THAT(files.readable, Contains(path("tools")));
  EXPECT_THAT(files.readable, Each(Ne(path("").parent_path()))) << "the home folder itself";
  EXPECT_THAT(files.readable, Each(Ne("/tmp"))) << "above the home folder";
  EXPECT_THAT(files.readable, Each(Ne(path("rivals/lib")))) << "of the other team";
  EXPECT_THAT(files.readable, Each(Ne("relative")));
}

}  // namespace
}  // namespace cls::match
