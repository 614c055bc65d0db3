// Commands keep files that exist.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

class Overwrite : public testing::Test, public ClsFolder {
 protected:
  CommandResult match(std::vector<std::string> more) {
    return run(joined({"match", "mock:hold", "mock:hold", "--set", "server::kick_off_wait=3",
                       "--seed", "7", "--cycles", "5"},
                      more));
  }
};

TEST_F(Overwrite, MatchRefusesFolderThatHoldsSomething) {
  write("x/match.rcg", "mine");
  EXPECT_THAT(
      match({"--dir", "x"}),
      Exits(73, "cls: x holds match.rcg; choose another name, or --force to rename it to x.old\n"));
  EXPECT_EQ(read_file(path("x/match.rcg")), "mine");
  EXPECT_FALSE(fs::exists(path("x/manifest.json")));
}

TEST_F(Overwrite, MatchKeepsOldFolderWithForce) {
  write("x/match.rcg", "mine");
  EXPECT_EQ(match({"--dir", "x", "--force"}).exit_code, 0);
  EXPECT_EQ(read_file(path("x.old/match.rcg")), "mine");
  EXPECT_TRUE(fs::exists(path("x/result.json")));
  EXPECT_EQ(match({"--dir", "x", "--force"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(path("x.old2/result.json")));
}

TEST_F(Overwrite, MatchPlaysInEmptyFolder) {
  fs::create_directories(path("x"));
  EXPECT_EQ(match({"--dir", "x"}).exit_code, 0);
}

TEST_F(Overwrite, MatchWithoutItsProgramsLeavesNothing) {
  const CommandResult team = run({"match", "team:nowhere", "mock"});
  EXPECT_EQ(team.exit_code, 69);
  EXPECT_EQ(team.err, "cls: team folder nowhere: no such folder\n");
  const CommandResult server = run({"match", "mock", "mock", "--server", "nowhere"});
  EXPECT_EQ(server.exit_code, 69);
  EXPECT_EQ(server.err, "cls: soccer server nowhere: no such program on PATH\n");
  Command bare({cls_binary(), "match", "mock", "mock", "--server", "rcssserver"}, {"PATH="},
               folder_.path());
  EXPECT_THAT(bare.finish().err, HasSubstr("no such program on PATH; `cls doctor` says how"));
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(Overwrite, MatchKeepsRecordedCalls) {
  write("calls.rpc", "mine");
  EXPECT_THAT(match({"--dir", "x", "--record-rpc", "calls.rpc"}),
              Exits(73, HasSubstr("calls.rpc exists")));
  EXPECT_EQ(match({"--dir", "x", "--record-rpc", "calls.rpc", "--force"}).exit_code, 0);
  EXPECT_EQ(read_file(path("calls.rpc.old")), "mine");
}

TEST_F(Overwrite, ConvertRefusesExistingFile) {
  const std::string log = fixture("gamelog/match-start.rcg.gz");
  write("out.rcg", "mine");
  EXPECT_THAT(run({"convert", log, "out.rcg"}),
              Exits(73, "cls: out.rcg: exists; use --force to replace it\n"));
  EXPECT_EQ(read_file(path("out.rcg")), "mine");
  run({"convert", log, "out.rcg", "--force"});
  EXPECT_NE(read_file(path("out.rcg")), "mine");
}

// The limit of the shell stops the log after some blocks.
TEST_F(Overwrite, ConvertThatFailsLeavesNothingNew) {
  const std::string log = fixture("gamelog/match-start.rcg.gz");
  write("out.rcg", "mine");
  for (const char* out : {"new.rcg", "out.rcg"}) {
    const std::string script = "trap '' XFSZ; ulimit -f 8; exec " + cls_binary().string() +
                               " convert " + log + " " + out + " --force";
    EXPECT_THAT(Command({"/bin/sh", "-c", script}, {}, folder_.path()).finish(), Exits(74));
  }
  EXPECT_EQ(read_file(path("out.rcg")), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(Overwrite, InitKeepsOldConfiguration) {
  write("cls.toml", "mine");
  EXPECT_EQ(run({"init"}).exit_code, 73);
  EXPECT_EQ(run({"init", "--force"}).exit_code, 0);
  EXPECT_EQ(read_file(path("cls.toml.old")), "mine");
}

TEST_F(Overwrite, ServerRefusesFolderWithLogs) {
  write("logs/match.rcl", "mine");
  EXPECT_THAT(run({"server", "--port", "0", "--dir", "logs"}),
              Exits(73, "cls: logs/match.rcl: exists; give --dir another folder\n"));
}

}  // namespace
}  // namespace cls::tests
