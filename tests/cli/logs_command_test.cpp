// `cls logs`: finds the match, lists its files, prints what the failed process wrote last.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/json.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;
using json = base::Json;

class LogsCommand : public testing::Test, public ClsFolder {
 protected:
  CommandResult play(const std::string& right, const std::string& dir) {
    return run({"match", "mock:hold", right, "--cycles", "5", "--set", "server::kick_off_wait=3",
                "--dir", dir});
  }

  const std::string crash_ = "run:echo one; echo boom {port}; exit 3";
};

TEST_F(LogsCommand, PrintsLastLinesOfFailedProcess) {
  EXPECT_NE(play(crash_, "m").exit_code, 0);
  const CommandResult shown = run({"logs", "m"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  for (const char* text : {"result (cls.match/1)", "right-playmaker.log",
                           "output of right Playmaker (exit code 3)", "  one\n", "  boom "}) {
    EXPECT_THAT(shown.out, HasSubstr(text)) << text;
  }
  const CommandResult one = run({"logs", "m", "--tail", "1"});
  EXPECT_THAT(one.out, Not(HasSubstr("  one\n")));
  EXPECT_THAT(one.out, HasSubstr("  boom "));
}

TEST_F(LogsCommand, PrintsDocument) {
  play(crash_, "m");
  const json document = json::parse(run({"logs", "m", "--json"}).out);
  EXPECT_EQ(document["schema"], "cls.logs/1");
  EXPECT_EQ(document["end_reason"], "refused");
  EXPECT_EQ(document["tail"]["process"], "right Playmaker");
  EXPECT_EQ(document["tail"]["lines"][0], "one");
  bool manifest = false;
  for (const json& file : document["files"]) manifest |= file["name"] == "manifest.json";
  EXPECT_TRUE(manifest);
}

TEST_F(LogsCommand, SelectsLatestFailedMatchOfFolder) {
  play("mock:hold", "runs/a");
  play(crash_, "runs/b");
  play("mock:hold", "runs/c");
  const CommandResult shown = run({"logs"});
  EXPECT_TRUE(shown.out.starts_with("runs/b  (the latest that failed)\n")) << shown.out;
}

TEST_F(LogsCommand, FindsMatchesOfTournament) {
  std::ofstream(path("cls.toml")) << "[tournament]\ncycles = 5\nkeep_logs = \"all\"\n"
                                     "[server]\nkick_off_wait = 3\n"
                                     "[teams.A]\nendpoint = \"mock:hold\"\n"
                                     "[teams.B]\nendpoint = \"mock:hold\"\n";
  ASSERT_THAT(run({"tournament", "run", "cup", "--quiet"}), Exits(0));
  const CommandResult second = run({"logs", "cup", "--match", "2"});
  EXPECT_TRUE(second.out.starts_with("cup/matches/000002-B-vs-A  (match 2)\n")) << second.out;
  EXPECT_THAT(second.out, HasSubstr("match.rcg.gz"));
  EXPECT_THAT(run({"logs", "cup"}).out, HasSubstr("none failed"));
  EXPECT_THAT(run({"logs", "cup", "--match", "9"}),
              Exits(66, "cls: cup has 2 matches, no match 9\n"));
}

TEST_F(LogsCommand, ReportsErrors) {
  EXPECT_EQ(run({"logs", "nowhere"}).err, "cls: nowhere: no such folder\n");
  fs::create_directories(path("empty"));
  EXPECT_EQ(run({"logs", "empty"}).err,
            "cls: empty: no match folder, no tournament and no folder of matches\n");
  play(crash_, "m");
  EXPECT_THAT(run({"logs", "m", "--process", "rigth Playmaker"}),
              Exits(2, HasSubstr("did you mean 'right Playmaker'?")));
}

TEST_F(LogsCommand, DeletesAllMatchesButTheNewest) {
  for (const char* name : {"runs/1", "runs/2", "runs/3"}) play("mock:hold", name);
  write("runs/notes/manifest.json", "{}");
  write("runs/running/manifest.json", "{}");
  write("runs/running/events.jsonl", "");
  const auto time = fs::file_time_type::clock::now();
  for (int age = 1; age <= 3; ++age) {  // 3 is the oldest
    fs::last_write_time(path("runs/" + std::to_string(age)) / "manifest.json",
                        time - std::chrono::hours(age));
  }

  const CommandResult listed = run({"logs", "runs", "--prune", "1", "--dry-run"});
  EXPECT_THAT(listed.out,
              testing::MatchesRegex("runs/3\nruns/2\nwould delete 2 matches, .* left\n"));
  EXPECT_TRUE(fs::exists(path("runs/3")));

  const json document = json::parse(run({"logs", "runs", "--prune", "1", "--json"}).out);
  EXPECT_EQ(document["folders"], (json{"runs/3", "runs/2"}));
  EXPECT_GT(document["bytes"], 1000);
  EXPECT_EQ(document["left"], 1);
  for (const char* name : {"runs/2", "runs/3"}) EXPECT_FALSE(fs::exists(path(name))) << name;
  for (const char* name : {"runs/1", "runs/notes", "runs/running"}) {
    EXPECT_TRUE(fs::exists(path(name))) << name;
  }

  ASSERT_THAT(run({"tournament", "run", "cup", "--team", "A=mock", "--team", "B=mock", "--cycles",
                   "5", "--rounds", "1"}),
              Exits(0));
  const CommandResult cup = run({"logs", "cup", "--prune", "0"});
  EXPECT_EQ(cup.exit_code, 66);
  EXPECT_THAT(cup.err, HasSubstr("cup: a tournament, whose report needs its matches"));
}

}  // namespace
}  // namespace cls::tests
