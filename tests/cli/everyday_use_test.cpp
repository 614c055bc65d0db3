// What users do from the first hour on: repeat commands, and call sides by their names in cls.toml.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class EverydayUse : public testing::Test {
 protected:
  EverydayUse() { write("cls.toml", "[teams.ada]\nendpoint = \"mock:hold\"\n"); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
  }

  CommandResult cls(Words words) {
    words.insert(words.begin(), cls_binary());
    Command command(words, {}, folder_.path());
    return command.finish();
  }

  TemporaryFolder folder_;
};

TEST_F(EverydayUse, MatchTakesTheFolderOfOneThatNeverBegan) {
  const CommandResult refused = cls({"match", "run:false {port}", "mock", "--dir", "first"});
  EXPECT_NE(refused.exit_code, 0);
  ASSERT_TRUE(fs::exists(folder_.path() / "first/result.json")) << refused.err;

  const Words again = {"match", "mock", "mock", "--dir", "first", "--cycles", "20"};
  EXPECT_EQ(cls(again).exit_code, 0);
  EXPECT_THAT(cls(again).err, HasSubstr("first holds ")) << "a match that was played";
}

TEST_F(EverydayUse, ADeletedWorkingFolderIsNamed) {
  fs::create_directory(folder_.path() / "gone");
  Command command(
      {"/bin/sh", "-c", "rmdir ../gone; exec '" + cls_binary().string() + "' compare mock mock"},
      {}, folder_.path() / "gone");
  EXPECT_THAT(command.finish(),
              Exits(66, HasSubstr("cls: the working folder does not exist any more")));
}

// Sanitizers reserve more address space than any limit leaves.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(EverydayUse, AnAbortForWantOfMemorySaysSo) {
  for (const std::string limit : {"-v 500000", "-d 100000"}) {
    Command command({"/bin/sh", "-c",
                     "ulimit " + limit + "; exec '" + cls_binary().string() +
                         "' match mock mock --cycles 20 --dir limited"},
                    {}, folder_.path());
    const CommandResult result = command.finish();
    fs::remove_all(folder_.path() / "limited");
    if (result.exit_code == 0) continue;  // there was memory enough, this time
    // 75: the memory ended where a thread is started, which names the limits.
    EXPECT_THAT(result.exit_code, testing::AnyOf(70, 75)) << result.err;
    EXPECT_THAT(result.err, HasSubstr("memory")) << limit;
  }
}
#endif

TEST_F(EverydayUse, MatchLeavesFilesOfUsersAlone) {
  cls({"match", "run:false {port}", "mock", "--dir", "first"});
  write("first/notes.txt", "mine");
  const CommandResult again = cls({"match", "mock", "mock", "--dir", "first", "--cycles", "20"});
  EXPECT_THAT(again.err, HasSubstr("first holds "));
  EXPECT_EQ(read_file(folder_.path() / "first/notes.txt"), "mine");
}

TEST_F(EverydayUse, WatchTakesTheLatestMatchThatHasALog) {
  ASSERT_EQ(cls({"match", "mock", "mock", "--dir", "runs/1", "--cycles", "20"}).exit_code, 0);
  cls({"match", "run:false {port}", "mock", "--dir", "runs/2"});
  EXPECT_THAT(cls({"watch", "runs", "--out", "page.html", "--no-open"}), Exits(0));
  EXPECT_TRUE(fs::exists(folder_.path() / "page.html"));
}

TEST_F(EverydayUse, NamesOfTeamsAreSidesOfTestsAndChecks) {
  const CommandResult tested =
      cls({"test", "--against", "ada", "--filter", "team_stays*", "--jobs", "1"});
  EXPECT_THAT(tested.err, Not(HasSubstr("unknown side")));
  EXPECT_THAT(cls({"check", "playmaker", "ada", "--calls", "20"}), Exits(0));

  EXPECT_THAT(cls({"test", "--against", "adda"}).err, HasSubstr("did you mean 'ada'?"));
  EXPECT_THAT(cls({"check", "playmaker", "adda"}).err, HasSubstr("did you mean 'ada'?"));
}

TEST_F(EverydayUse, ProgramsAsSidesSuggestRun) {
  fs::remove(folder_.path() / "cls.toml");
  EXPECT_THAT(cls({"match", "team.py", "mock"}).err,
              HasSubstr("did you mean 'run:python3 team.py --port {port}'?"));
  EXPECT_THAT(cls({"match", "node team.js --port {port}", "mock"}).err,
              HasSubstr("did you mean 'run:node team.js --port {port}'?"));
}

// The project is in a folder below the working folder.
TEST_F(EverydayUse, FoldersAsSidesSuggestWhatTheyHold) {
  fs::remove(folder_.path() / "cls.toml");
  fs::create_directories(folder_.path() / "ada");
  EXPECT_THAT(cls({"match", "ada", "mock"}).err, HasSubstr("unknown side 'ada' (a side is"));
  write("ada/cls.toml", "[teams.ada]\nendpoint = \"mock:hold\"\n");
  EXPECT_THAT(cls({"match", "ada", "mock"}),
              Exits(2, HasSubstr("cd ada first, or --config ada/cls.toml")));
  const Words named = {"match", "ada", "mock", "--config", "ada/cls.toml", "--cycles", "20"};
  EXPECT_EQ(cls(named).exit_code, 0);

  fs::create_directories(folder_.path() / "helios");
  write("helios/start", "#!/bin/sh\n");
  EXPECT_THAT(cls({"match", "helios", "mock"}).err, HasSubstr("did you mean 'team:helios'?"));
}

TEST_F(EverydayUse, WatchOfAMatchThatNeverBeganNamesItsLogs) {
  cls({"match", "run:false {port}", "mock", "--dir", "runs/1"});
  EXPECT_THAT(cls({"watch", "runs"}).err,
              HasSubstr("runs/1: no game log (*.rcg, *.rcg.gz); cls logs runs/1 says"));
}

// An interrupted match has a message that says no more than its end reason.
TEST_F(EverydayUse, LogsSayTheEndReasonOnce) {
  Command command({cls_binary(), "match", "mock", "mock", "--speed", "1", "--dir", "1"}, {},
                  folder_.path());
  while (!fs::exists(folder_.path() / "1/match.rcg")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  command.send_signal(SIGINT);
  EXPECT_EQ(command.finish().exit_code, 130);
  EXPECT_THAT(cls({"logs", "1"}).out, HasSubstr("interrupted\n"));
  EXPECT_THAT(cls({"logs", "1"}).out, Not(HasSubstr("interrupted: interrupted")));
}

// Not as root, who may write everywhere: a file stands where the folder would be.
TEST_F(EverydayUse, FoldersThatCannotBeCreatedSuggestOthers) {
  write("runs", "");
  EXPECT_THAT(cls({"match", "mock", "mock", "--cycles", "20"}).err, HasSubstr("; --dir DIR"));
  EXPECT_THAT(cls({"compare", "mock", "mock:hold"}).err, HasSubstr("; --dir selects"));
}

TEST_F(EverydayUse, ExplainKnowsPluralsAndWordsOfUsers) {
  EXPECT_THAT(cls({"explain", "tackles"}).out, StartsWith("tackle (action"));
  EXPECT_THAT(cls({"explain", "keeper"}).out, StartsWith("helios_goalie (action"));
  EXPECT_THAT(cls({"explain", "zebras"}).err, HasSubstr("unknown name 'zebras'"));
}

}  // namespace
}  // namespace cls::tests
