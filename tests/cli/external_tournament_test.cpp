// External teams in tournaments over UDP: names, and results of matches with crashes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/marked_processes.h"
#include "tests/support/port_lock.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using json = base::Json;
using Arguments = std::vector<std::string>;

// A mock and an external team of 11 fake players on the fake server: two matches, sides swapped.
class ExternalTournament : public testing::Test {
 protected:
  void SetUp() override {
    script("server", "exec " + built("cls_fake_server") + " \"$@\"");
    std::ofstream(path() / "cls.toml")
        << "[tournament]\ncycles = 25\nserver = \"" << (path() / "server").string()
        << "\"\n[server]\nkick_off_wait = 3\n"
           "[teams.HOLD]\nendpoint = \"mock:hold\"\n"
           "[teams.GUESTS]\nendpoint = \"team:team\"\n";
  }

  void TearDown() override { EXPECT_TRUE(all_marked_gone(mark_)); }

  void script(const std::string& name, const std::string& text) const {
    const fs::path file = path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "#!/bin/sh\n" << export_mark(mark_) << text << "\n";
    ::chmod(file.c_str(), 0755);
  }

  // start.sh of a team named Others; `more` is shell code that may extend $flags.
  void team(const std::string& more) const {
    script("team/start.sh",
           "while [ $# -gt 0 ]; do case $1 in -p) port=$2;; esac; shift 2; done\n" + more +
               "\nfor i in $(seq 11); do\n  goalie=; [ $i = 1 ] && goalie='--goalie 1'\n" +
               copy_built("cls_fake_player", path() / "team") +
               " --port $port --name Others $goalie $flags &\n  sleep 0.02\ndone");
  }

  CommandResult play(const Arguments& more = {}) const {
    return run(joined({cls_binary(), "tournament", "run", path() / "cup", "--config",
                       path() / "cls.toml", "--json"},
                      more),
               {std::string(kMarkVariable) + "=" + mark_});
  }

  fs::path path() const { return folder_.path(); }

  TemporaryFolder folder_;
  // External teams take the usual ports of a server if they are free, which other tests need.
  const PortLock ports_;
  const std::string mark_ = new_mark();
};

// On a loaded host a short match may finish before the crash of a team is detected.
const Arguments kLong = {"--cycles", "6000"};

json row_of(const json& report, const std::string& team) {
  for (const json& row : report["standings"]) {
    if (row["team"] == team) return row;
  }
  return {};
}

TEST_F(ExternalTournament, ListsTeamByConfiguredName) {
  team("");
  const CommandResult played = play();
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const json report = json::parse(played.out);
  EXPECT_EQ(row_of(report, "GUESTS")["played"], 2);
  for (const json& match : report["matches"]) {
    EXPECT_EQ(match["end_reason"], "finished");
    const std::string side = match["left"] == "GUESTS" ? "left" : "right";
    const json result =
        json::parse(read_file(path() / "cup" / match["folder"].get<std::string>() / "result.json"));
    EXPECT_EQ(result[side]["name"], "Others") << "on the pitch";
    EXPECT_THAT(match["command"].get<std::string>(), HasSubstr("--own-names"));
  }
  EXPECT_NE(report["matches"][0]["left"], report["matches"][1]["left"]);
}

TEST_F(ExternalTournament, StopsAfterCrash) {
  team("flags='--exit-at-cycle 10'");
  const CommandResult played = play(kLong);
  EXPECT_EQ(played.exit_code, 1);
  EXPECT_THAT(played.err, HasSubstr("is invalid (crashed): "));
  EXPECT_THAT(played.err, HasSubstr("see "));
  EXPECT_EQ(json::parse(played.out)["counts"]["finished"], 0);
}

TEST_F(ExternalTournament, CountsCrashAsForfeit) {
  team("flags='--exit-at-cycle 10'");
  const CommandResult played = play({"--on-crash", "forfeit", kLong[0], kLong[1]});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  const json report = json::parse(played.out);
  EXPECT_EQ(report["counts"]["forfeits"], 2);
  for (const json& match : report["matches"]) {
    const bool left = match["left"] == "GUESTS";
    EXPECT_EQ(match["end_reason"], "crashed");
    EXPECT_EQ(match["fault"], left ? "left" : "right");
    EXPECT_EQ(match["score"], left ? json({0, 3}) : json({3, 0}));
  }
  EXPECT_EQ(row_of(report, "GUESTS")["goals_against"], 6);
}

TEST_F(ExternalTournament, RetriesMatchAfterCrash) {
  team("if [ ! -e crashed ]; then touch crashed; flags='--exit-at-cycle 10'; fi");
  const CommandResult played =
      play({"--on-crash", "rerun", "--concurrency", "1", "--cycles", "500"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  const json report = json::parse(played.out);
  EXPECT_EQ(report["counts"]["finished"], 2);
  EXPECT_EQ(report["matches"][0]["attempts"], 2);
  EXPECT_EQ(report["matches"][1]["attempts"], 1);
}

TEST_F(ExternalTournament, RunsTeamWithFixedPortsInSequence) {
  script("team/start", "exit 1");
  const CommandResult played = play({"--concurrency", "4", "--on-crash", "forfeit"});
  EXPECT_THAT(played.err, HasSubstr("one match at a time: GUESTS requires the ports 6000 to 6002"));
}

}  // namespace
}  // namespace cls::tests
