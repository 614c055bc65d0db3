// All commands where TMPDIR has no room for temporary files: none takes the working folder instead,
// or blames it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::IsSubsetOf;
using testing::Not;
namespace fs = std::filesystem;

/// A command line, and the names that it may create in the working folder.
struct Use {
  std::vector<std::string> words;
  std::vector<std::string> creates = {};
};

const std::vector<Use>& uses() {
  static const std::vector<Use> all = {
      {{"match", "mock:hold", "mock:hold", "--cycles", "5", "--dir", "match"}, {"match"}},
      {{"tournament", "check-in", "cup"}},
      {{"tournament", "plan", "cup"}},
      {{"tournament", "run", "cup", "--no-preflight", "--quiet"}},
      {{"tournament", "status", "cup"}},
      {{"tournament", "report", "cup"}},
      {{"tournament", "stop", "cup"}},
      {{"tournament", "pause", "cup", "--reason", "network"}},
      {{"tournament", "resume", "cup"}},
      {{"tournament", "decide", "cup"}},
      {{"tournament", "archive", "cup"}},
      {{"tournament", "watch", "cup", "--listen", "nowhere"}},
      {{"tournament", "work", "cup", "--index", "1"}},
      {{"tune", "init", "search"}, {"search"}},
      {{"tune", "run", "search", "--generations", "1", "--cycles", "5"}},
      {{"tune", "status", "search"}},
      {{"tune", "report", "search"}},
      {{"compare", "mock:hold", "mock:hold", "--cycles", "5", "--max-pairs", "1", "--dir", "duel"},
       {"duel"}},
      {{"test", "referee_corner_kick", "--dir", "tested"}, {"tested"}},
      {{"dev", "no_such_scenario"}},
      {{"results", "match"}},
      {{"stats", "match"}},
      {{"review", "match/match.rcg"}},
      {{"logs", "match"}},
      {{"convert", "match", "--tables", "tables"}, {"tables"}},
      {{"book", "make", "match", "--out", "moments.book"}},
      {{"challenge", "stp", "make", "tables", "tests"}, {"tests"}},
      {{"dataset", "make", "cup/cls.toml", "data", "--quiet"}, {"data"}},
      {{"dataset", "verify", "data"}},
      {{"watch", "match", "--no-open"}},
      {{"report", "match"}},
      {{"check", "playmaker", "mock", "--calls", "10"}},
      {{"check", "server", "embedded"}},
      {{"check", "server-log", "match/match.rcg", "match/match.rcl"}},
      {{"check", "perception", "none.txt", "--truth", "match/match.rcg"}},
      {{"doctor", "--server", "embedded", "--playmaker", "mock"}},
      {{"mock", "no_such_behavior"}},
      {{"proxy", "--port", "1", "--rpc-port", "1", "--start-timeout", "0.1"}},
      {{"server", "server::no_such_parameter=1"}},
      {{"explain", "stalled"}},
      {{"config"}},
      {{"init", "other"}, {"other"}},
      {{"new", "python", "bob", "--dir", "project"}, {"project"}},
      {{"package-team", "ada"}},
      {{"qualify", "mock:hold", "mock:simple", "--half-time", "1", "--mode", "lockstep"},
       {"qualification", "hold_logs.tar.gz", "mock_logs.tar.gz"}},
      {{"completion", "bash"}},
      {{"train", "spec"}},
      {{"version"}},
      {{"help", "topics"}},
  };

  return all;
}

class TemporaryFiles : public testing::Test, public ClsFolder {
 protected:
  TemporaryFiles() : ClsFolder(std::chrono::seconds(240)) {
    write("cup/cls.toml",
          "[tournament]\nrounds = 1\n[match]\ncycles = 5\n"
          "[teams.A]\nendpoint = \"mock:hold\"\n[teams.B]\nendpoint = \"mock:hold\"\n");
    write("cls.toml", "[teams.ada]\nendpoint = \"run:python3 play.py --port {port}\"\n");
    write("play.py", "import json\n");
  }

  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      found.insert(entry.path().filename());
    }
    return found;
  }
};

TEST_F(TemporaryFiles, AreWrittenToNoOtherFolderByAnyCommand) {
  for (const Use& use : uses()) {
    SCOPED_TRACE(testing::PrintToString(use.words));
    std::set<std::string> allowed = names();
    allowed.insert(use.creates.begin(), use.creates.end());

    const CommandResult result = run(use.words, {"TMPDIR=/nonexistent"});
    EXPECT_GE(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("working folder does not exist")));
    EXPECT_THAT(names(), IsSubsetOf(allowed));
  }
}

TEST_F(TemporaryFiles, AreMissingWithTheirFolderInTheError) {
  for (const char* place : {"/nonexistent", "/dev/null"}) {
    EXPECT_THAT(run({"package-team", "ada"}, {std::string("TMPDIR=") + place}),
                Exits(73, HasSubstr(place)));
  }
}

TEST_F(TemporaryFiles, OfAllCommandsAreTested) {
  std::set<std::string> tested;
  for (const Use& use : uses()) tested.insert(use.words.front());

  const std::string help = run({"--help"}).out;
  std::istringstream lines(help.substr(help.find("COMMAND\n")));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ") || line.starts_with("  -") || line.starts_with("   ")) continue;
    const std::string command = line.substr(2, line.find(' ', 2) - 2);
    EXPECT_TRUE(tested.contains(command)) << command;
  }
}

}  // namespace
}  // namespace cls::tests
