// Settings, logs and report of `cls server`.
#include "match/terms/server_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "match/server/server_logs.h"
#include "match/server/server_report.h"
#include "match/terms/match_settings.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::match {
namespace {

using testing::HasSubstr;
using tests::TemporaryFolder;

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

TEST(ServerSettings, LaterArgumentsOverrideEarlierOnes) {
  ServerSettings settings;
  ASSERT_TRUE(apply_arguments(
      settings, {"server::half_time=100", "--server::synch_mode=on", "server::half_time", "=", "50",
                 "player::random_seed=5", "CSVSaver::save=on", "CSVSaver::filename='a b'",
                 "sync.max_wait_ms=300", "sync::max_missed=3"}));
  EXPECT_EQ(settings.server.half_time, 50);
  EXPECT_TRUE(settings.server.synch_mode);
  EXPECT_EQ(settings.player.random_seed, 5);
  EXPECT_TRUE(settings.save_csv);
  EXPECT_EQ(settings.csv_file, "a b");
  EXPECT_EQ(settings.max_wait_ms, 300);
  EXPECT_EQ(settings.max_missed, 3);
}

TEST(ServerSettings, ReportsFileAndLineOfErrorsInIncludedFiles) {
  TemporaryFolder folder;
  const std::filesystem::path here = folder.path();
  write(here / "server.conf", "server::version = '19.0.0'\nserver::half_time = 7\n");
  write(here / "player.conf", "include = 'more.conf'\n");
  write(here / "more.conf", "# types\nplayer::player_types = 3\n");
  ServerSettings settings;
  const auto found = apply_folder(settings, here);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->size(), 2u);
  EXPECT_EQ(settings.server.half_time, 7);
  EXPECT_EQ(settings.player.player_types, 3);

  write(here / "more.conf", "# types\nplayer::player_type = 3\n");
  const auto wrong = apply_folder(settings, here);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().message,
            (here / "player.conf").string() + ":1: " + (here / "more.conf").string() +
                ":2: unknown parameter 'player_type'; did you mean 'player_types'?");

  write(here / "player.conf", "include = 'player.conf'\n");
  EXPECT_THAT(apply_folder(settings, here).error().message, HasSubstr("circular include"));

  write(here / "server.conf", "server::version = '18.1.0'\n");
  EXPECT_EQ(apply_folder(settings, here).error().message,
            (here / "server.conf").string() +
                ":1: a configuration of version 18.1.0, not 19.0.0; compare its values with "
                "docs/server.md and set the version to '19.0.0', or delete the file for the "
                "defaults");
}

// rcssserver serverparam.cpp: setSlowDownFactor, setNrNormalHalfs, setFoulDetectProbability, ...
TEST(ServerSettings, AreLimitedAsInRcssserver) {
  ServerSettings settings;
  ASSERT_TRUE(apply_arguments(
      settings, {"server::slow_down_factor=0", "server::nr_normal_halfs=-1",
                 "server::nr_extra_halfs=-2", "server::extra_half_time=-5",
                 "server::foul_detect_probability=3", "server::red_card_probability=-0.5"}));
  EXPECT_EQ(settings.server.slow_down_factor, 1);
  EXPECT_EQ(settings.server.nr_normal_halfs, 0);
  EXPECT_EQ(settings.server.nr_extra_halfs, 0);
  EXPECT_EQ(settings.server.extra_half_time, 0);
  EXPECT_EQ(settings.server.foul_detect_probability, 1.0);
  EXPECT_EQ(settings.server.red_card_probability, 0.0);
  ASSERT_TRUE(apply_arguments(settings, {"server::foul_detect_probability=0.25"}));
  EXPECT_EQ(settings.server.foul_detect_probability, 0.25);
}

TEST(ServerSettings, DoNotShortenHalvesBySlowDownFactor) {
  soccer::ServerParams params;
  const int half = params.half_time_cycles();
  params.slow_down_factor = 3;
  EXPECT_EQ(params.half_time_cycles(), half);
  EXPECT_EQ(params.extra_half_time_cycles(), 1000);
}

TEST(ServerSettings, ExpandTheTildeInPaths) {
  ASSERT_NE(std::getenv("HOME"), nullptr);
  const std::string home = std::getenv("HOME");
  ServerSettings settings;
  ASSERT_TRUE(apply_arguments(settings, {"server::game_log_dir=~/logs", "server::text_log_dir=~",
                                         "server::team_l_start=~/team/start.sh",
                                         "server::landmark_file=~/x", "CSVSaver::filename=~/a"}));
  EXPECT_EQ(settings.server.game_log_dir, home + "/logs");
  EXPECT_EQ(settings.server.text_log_dir, home);
  EXPECT_EQ(settings.server.team_l_start, home + "/team/start.sh");
  EXPECT_EQ(settings.server.landmark_file, "~/x") << "as in rcssserver";
  EXPECT_EQ(settings.csv_file, home + "/a");
  ASSERT_TRUE(apply_arguments(settings, {"server::game_log_dir=~nosuchuser/logs"}));
  EXPECT_EQ(settings.server.game_log_dir, "~nosuchuser/logs");
}

TEST(ServerSettings, ReportsInvalidArguments) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"server::no_such=1", "unknown parameter 'no_such'"},
      {"trainer::a=1", "'a': must begin with server, player, CSVSaver or sync, not 'trainer'"},
      {"server::half_time=long", "parameter 'half_time': 'long' is not a whole number"},
      {"sync::max_wait_ms=0", "parameter 'max_wait_ms': 0 is too small"},
      {"include=/no/such.conf", "cannot read /no/such.conf"},
      {"include=/dev/zero", "cannot read /dev/zero: not a regular file"},
  };
  for (const auto& [word, message] : mistakes) {
    ServerSettings settings;
    const auto done = apply_arguments(settings, {word});
    ASSERT_FALSE(done) << word;
    EXPECT_THAT(done.error().message, testing::StartsWith(message));
  }
}

gamelog::TeamFrames result_3_1() {
  gamelog::TeamFrames teams;
  teams[0].name = "A/B";
  teams[0].score = 3;
  teams[1].score = 1;
  return teams;
}

TEST(ServerLogs, AreRenamedAtTheEndOfTheMatch) {
  TemporaryFolder folder;
  const std::filesystem::path here = folder.path();
  soccer::ServerParams params;
  params.game_log_dir = params.text_log_dir = (here / "new").string();
  params.game_log_compression = 6;
  params.text_log_dated = false;
  params.log_date_format = "D-";
  auto logs = ServerLogs::open(params, 0);

  ASSERT_TRUE(logs) << logs.error().message;

  logs->sinks().game->write("game");
  logs->sinks().text->write("text");
  EXPECT_TRUE(std::filesystem::exists(here / "new/incomplete.rcg.gz"));
  ASSERT_TRUE(logs->finish(result_3_1()));
  EXPECT_EQ(tests::read_file(here / "new/D-A_B_3-vs-null.rcg.gz"), "game");
  EXPECT_EQ(tests::read_file(here / "new/A_B_3-vs-null.rcl"), "text");
  EXPECT_FALSE(std::filesystem::exists(here / "new/incomplete.rcg.gz"));
}

TEST(ServerLogs, KeepFixedNamesAndCanBeDisabled) {
  TemporaryFolder folder;
  soccer::ServerParams params;
  params.game_log_dir = folder.path();
  params.game_log_fixed = true;
  params.game_log_fixed_name = "mine";
  params.text_logging = false;
  auto logs = ServerLogs::open(params, 0);
  ASSERT_TRUE(logs);
  EXPECT_EQ(logs->sinks().text, nullptr);
  ASSERT_TRUE(logs->finish(result_3_1()));
  ASSERT_EQ(logs->paths().size(), 1u);
  EXPECT_EQ(logs->paths()[0].filename(), "mine.rcg");
}

TEST(ServerReport, MatchesRcssserver) {
  setenv("TZ", "UTC", 1);
  ServerReport report;
  report.start = 1795207137;  // 2026-11-20 20:38:57
  report.left.name = "TA";
  report.left.coach = "Cch";
  report.right.name = "TB";

  EXPECT_EQ(console_report(report, false),
            "\nSaving Results:\n\tCSVSaver: saving...\n\tCSVSaver: ...disabled\n"
            "\tSTDOutSaver: saving...\n\nGame Results:\n\t2026-11-20 20:38:57\n\t'TA' vs 'TB'\n"
            "\tLeft Coach: 'Cch'\n\tScore: 0 - 0\n \n\tSTDOutSaver: ...saved\n\n"
            "Saving Results Complete\n");
  EXPECT_EQ(csv_line(report),
            "2026-11-20 20:38:57, \"TA\", \"TB\", \"Cch\", NULL, 0, 0, NULL, NULL, NULL, NULL, "
            "NULL\n");

  report.right = {};
  report.left.penalties_taken = 3;
  report.left.penalties_scored = 2;
  report.coin_toss_winner = soccer::Side::kRight;
  EXPECT_THAT(console_report(report, true),
              AllOf(HasSubstr("\t'TA' vs null\n"),
                    HasSubstr(" \tPenalties: 2 (3) - 0 (0)\n\tCoin Toss Winner: Right Team\n\n")));
  EXPECT_THAT(csv_line(report), HasSubstr("0, 0, 3, 0, 2, 0, RIGHT\n"));
}

// Saved matches leave them out: all that concern logs, however they are called.
TEST(MatchSettings, LogParametersAreKnown) {
  for (const auto& row : soccer::server_param_table()) {
    const std::string name(row.name);
    const bool says_log = name.find("log") != std::string::npos;
    EXPECT_EQ(is_log_parameter(name), says_log) << name;
  }
}

}  // namespace
}  // namespace cls::match
