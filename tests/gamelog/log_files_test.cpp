// Logs that command arguments refer to.
#include "gamelog/files/log_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace cls::gamelog {
namespace {

namespace fs = std::filesystem;

class FindLogs : public testing::Test {
 protected:
  std::string make(const std::string& name) {
    const fs::path path = folder_.path() / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "x";
    return path.string();
  }
  std::string folder() const { return folder_.path().string(); }

  tests::TemporaryFolder folder_;
};

TEST_F(FindLogs, PairsLogsOfAMatch) {
  const std::string game = make("b/game-vs-x.rcg.gz");
  const std::string text = make("b/game-vs-x.rcl");
  const std::string alone = make("a.rcl.gz");
  make("notes.txt");
  const FoundLogs found = find_logs({folder()});

  ASSERT_EQ(found.matches.size(), 2u);
  EXPECT_EQ(found.matches[0].game, "");
  EXPECT_EQ(found.matches[0].text, alone);
  EXPECT_EQ(found.matches[1].game, game);
  EXPECT_EQ(found.matches[1].text, text);

  const FoundLogs named = find_logs({game});
  EXPECT_EQ(named.matches.at(0).text, text);
  EXPECT_EQ(find_logs({text, game}).matches.size(), 1u);
}

// A log and its compressed copy are one match; two matches may have the same name, too.
TEST_F(FindLogs, TwoLogsOfOneNameAreOneMatchIfTheirBytesAreEqual) {
  const std::string plain = make("a.rcg");
  const std::string packed = make("a.rcg.gz");
  make("a.rcl.xz");
  EXPECT_EQ(find_logs({plain, packed, plain}).matches.size(), 1u);
  ASSERT_EQ(find_logs({folder()}).matches.size(), 1u);
  EXPECT_EQ(find_logs({folder()}).matches[0].text, folder() + "/a.rcl.xz");

  std::ofstream(packed) << "another match";
  const FoundLogs found = find_logs({plain, packed});
  ASSERT_EQ(found.matches.size(), 2u);
  EXPECT_EQ(found.matches[0].game, plain);
  EXPECT_EQ(found.matches[1].game, packed);
  EXPECT_EQ(find_logs({folder()}).matches.size(), 2u);
}

// Copies in the archive of a cup must not count twice.
TEST_F(FindLogs, PassesByFoldersThatAreSetApart) {
  make("cup/matches/1/match.rcg");
  make("cup/archive/final/match.rcg");
  ASSERT_TRUE(set_apart(folder() + "/cup/archive"));
  EXPECT_EQ(find_logs({folder()}).matches.size(), 1u);
  EXPECT_EQ(find_logs({folder() + "/cup"}).matches.size(), 1u);
  EXPECT_EQ(find_logs({folder() + "/cup/archive"}).matches.size(), 1u) << "the user's wish";
}

// Opening a pipe waits for a writer.
TEST_F(FindLogs, SkipsPipesThatAreNotNamed) {
  const std::string game = make("m/match.rcg");
  ASSERT_EQ(::mkfifo((folder() + "/m/match.rcl").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo((folder() + "/other.rcg").c_str(), 0600), 0);
  const FoundLogs found = find_logs({folder()});
  ASSERT_EQ(found.matches.size(), 1u);
  EXPECT_EQ(found.matches[0].game, game);
  EXPECT_EQ(found.matches[0].text, "");
  EXPECT_EQ(find_logs({folder() + "/other.rcg"}).matches.size(), 1u) << "the user's wish";
}

TEST_F(FindLogs, ExpandsPatternsAndReportsMissingLogs) {
  make("1.rcg");
  make("2.rcg");
  make("sub/3.rcg");
  EXPECT_EQ(find_logs({folder() + "/?.rcg"}).matches.size(), 2u);
  EXPECT_EQ(find_logs({folder() + "/*"}).matches.size(), 3u);

  const FoundLogs none = find_logs({folder() + "/9.rcg", folder() + "/*.rcl", "-"});
  EXPECT_EQ(none.missing.size(), 2u);
  ASSERT_EQ(none.matches.size(), 1u);
  EXPECT_EQ(none.matches[0].game, "-");
}

TEST_F(FindLogs, PrefersFileOverPatternOfSameName) {
  const std::string odd = make("a[1].rcg");
  make("a1.rcg");
  const FoundLogs found = find_logs({odd});
  ASSERT_EQ(found.matches.size(), 1u);
  EXPECT_EQ(found.matches[0].game, odd);
}

}  // namespace
}  // namespace cls::gamelog
