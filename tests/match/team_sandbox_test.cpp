// The folders that the sandbox of an external team has.
#include "match/programs/team_sandbox.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;

bool has(const std::vector<fs::path>& folders, const fs::path& one) {
  return std::find(folders.begin(), folders.end(), one) != folders.end();
}

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
  EXPECT_TRUE(has(files.readable, "/usr"));
  EXPECT_TRUE(has(files.readable, "/etc"));
  EXPECT_TRUE(has(files.writable, path("team")));
  EXPECT_TRUE(has(files.writable, "/dev/null"));
  for (const auto& folders : {files.readable, files.writable}) {
    EXPECT_FALSE(has(folders, "/"));
    EXPECT_FALSE(has(folders, path("")));
    EXPECT_FALSE(has(folders, "/tmp"));
  }
}

TEST_F(TeamSandbox, LeavesOutHiddenFoldersOfTheSystem) {
  const process::FileAccess files = team_files(path("team"), {"/usr/share/", "/dev/shm/runs"});
  EXPECT_FALSE(has(files.readable, "/usr"));
  EXPECT_FALSE(has(files.readable, "/usr/share"));
  EXPECT_TRUE(has(files.readable, "/usr/bin"));
  EXPECT_TRUE(has(files.readable, "/usr/lib"));
  EXPECT_FALSE(has(files.writable, "/dev/shm"));
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
  EXPECT_TRUE(has(files.readable, path("tools")));
  EXPECT_FALSE(has(files.readable, path("").parent_path())) << "the home folder itself";
  EXPECT_FALSE(has(files.readable, "/tmp")) << "above the home folder";
  EXPECT_FALSE(has(files.readable, path("rivals/lib"))) << "of the other team";
  EXPECT_FALSE(has(files.readable, "relative"));
}

}  // namespace
}  // namespace cls::match
