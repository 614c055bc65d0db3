// Tests of the list of files that tests of the tree read.
#include "tests/architecture/source_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

class FilesOfProject : public testing::Test {
 protected:
  FilesOfProject() {
    for (const char* folder : {"cli", "build/cli", ".cache"}) fs::create_directories(path(folder));
    for (const char* name :
         {"README.md", "cli/a.cpp", "cli/note.cpp", "build/cli/b.cpp", ".cache/c.cpp"}) {
      std::ofstream(path(name)) << "text\n";
    }
  }
  void git(std::vector<std::string> words) const {
    words.insert(words.begin(), {"git", "-C", folder_.path()});
    const CommandResult done = run(words);
    ASSERT_EQ(done.exit_code, 0) << done.err;
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

TEST_F(FilesOfProject, AreThoseThatGitTracks) {
  git({"init", "--quiet"});
  git({"add", "--force", "README.md", "cli/a.cpp", ".cache/c.cpp"});
  EXPECT_THAT(files_of_project(folder_.path()), ElementsAre(path("README.md"), path("cli/a.cpp")));
}

TEST_F(FilesOfProject, LinksAreListedWhereverTheyLead) {
  fs::create_symlink("cli", path("folder"));
  fs::create_symlink("/nowhere", path(".cache/broken"));
  fs::create_symlink("README.md", path("untracked"));
  EXPECT_THAT(links_of_project(folder_.path()), testing::IsEmpty());
  git({"init", "--quiet"});
  git({"add", "--force", "README.md", "folder", ".cache/broken"});
  EXPECT_THAT(links_of_project(folder_.path()), ElementsAre(path(".cache/broken"), path("folder")));
}

TEST_F(FilesOfProject, AreAllOfUnpackedArchive) {
  EXPECT_THAT(files_of_project(folder_.path()),
              ElementsAre(path("README.md"), path("cli/a.cpp"), path("cli/note.cpp")));
}

}  // namespace
}  // namespace cls::tests
