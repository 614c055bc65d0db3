// Game logs of rcssserver 19, parsed and written again: every byte must be equal.
#include "gamelog/rcg/rcg_writer.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "gamelog/rcg/rcg_text.h"
#include "soccer/messages/parameter_message.h"
#include "tests/support/files.h"
#include "tests/support/rcg_lines.h"

namespace cls::gamelog {
namespace {

using soccer::PlayMode;
using soccer::Side;

/// Writes the parameters, frames and messages of an rcssserver log.
std::string written_again(std::string_view log) {
  base::StringSink sink;
  RcgWriter writer(sink);
  soccer::ServerParams server;
  soccer::PlayerParams player;
  std::vector<soccer::PlayerType> types;
  Frame frame;
  bool header_written = false;

  for (const std::string_view line : tests::split_lines(log)) {
    base::Result<void> read;
    if (line.starts_with("(server_param ")) read = soccer::parse(line, server);
    if (line.starts_with("(player_param ")) read = soccer::parse(line, player);
    if (line.starts_with("(player_type ")) read = soccer::parse(line, types.emplace_back());
    EXPECT_TRUE(read.ok()) << line;
    if (line.starts_with("(playmode ")) tests::read_play_mode(line, frame);
    if (line.starts_with("(team ")) tests::read_team(line, frame);
    if (!line.starts_with("(show ")) continue;
    if (!header_written) writer.write_header(server, player, types);
    header_written = true;
    tests::read_show(line, frame);
    writer.write_step(frame);
  }

  writer.write_end(frame);
  return sink.bytes();
}

std::string replaced(std::string text, std::string_view old, std::string_view with) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  if (at != std::string::npos) text.replace(at, old.size(), with);
  return text;
}

/// Reports only the first line that differs, because the logs have tens of megabytes.
void expect_same_lines(std::string_view expected, std::string_view actual) {
  const auto expected_lines = tests::split_lines(expected);
  const auto actual_lines = tests::split_lines(actual);
  ASSERT_EQ(expected_lines.size(), actual_lines.size());
  for (std::size_t i = 0; i < expected_lines.size(); ++i) {
    ASSERT_EQ(expected_lines[i], actual_lines[i]) << "line " << i + 1;
  }
  EXPECT_EQ(expected, actual);
}

TEST(RcgWriter, ReproducesRcssserverLogByteForByte) {
  const std::string log = tests::read_file(tests::fixture("gamelog/rcg-v6-excerpt.rcg.gz"));
  expect_same_lines(replaced(log, "(result 202611202101 ", "(result 197001010000 "),
                    written_again(log));
}

TEST(RcgWriter, ReproducesWholeRcssserverMatchesByteForByte) {
  for (const char* name : {"helios-vs-helios-full", "extra-time-and-penalties", "rcg-v6"}) {
    const auto path = tests::data("logs/" + std::string(name) + ".rcg.gz");
    if (!path) GTEST_SKIP() << "no data: set CLS_DATA";
    SCOPED_TRACE(name);
    const std::string log = tests::read_file(*path);
    // Only date and folders may differ.
    const std::size_t result = log.find("(result ") + 8;
    std::string expected = log;
    expected.replace(result, 12, "197001010000");
    for (const std::string_view key : {"(game_log_dir \"", "(text_log_dir \""}) {
      const std::size_t value = expected.find(key) + key.size();
      expected.replace(value, expected.find('"', value) - value, "./");
    }
    expect_same_lines(expected, written_again(log));
  }
}

PlayerFrame standing() {
  PlayerFrame player;
  player.stamina = 8000;
  player.effort = 1;
  player.recovery = 1;
  player.capacity = 130600;
  return player;
}

std::string show_of_first_player(const PlayerFrame& player) {
  Frame frame;
  frame.players.fill(standing());
  frame.players[0] = player;
  std::string line;
  append_show(frame, line);
  return line.substr(0, line.find(" ((l 2)"));
}

TEST(RcgText, FormatsAllPlayerValues) {
  // Player 1 of a show that rcssserver sent to a version 5 monitor.
  PlayerFrame player = standing();
  player.type = 2;
  player.state = 0x1;
  player.position = {-5, 5};
  player.body = 30;
  player.neck = 90;
  player.view_width = 60;
  player.focus_distance = 10;
  player.focus_direction = 20;
  player.effort = 0.92353;
  player.attention_side = Side::kLeft;
  player.attention_unum = 2;
  player.counts = {0, 2, 2, 0, 2, 2, 2, 2, 1, 1, 1, 1};

  EXPECT_EQ(show_of_first_player(player),
            "(show 0 ((b) 0 0 0 0) ((l 1) 2 0x1 -5 5 0 0 30 90 (v h 60) (fp 10 20) (s 8000 0.92353 "
            "1 130600) (f l 2) (c 0 2 2 0 2 2 2 2 1 1 1 1))");
}

TEST(RcgText, FormatsEmptySlotWithoutPrefixAndAttention) {
  PlayerFrame player = standing();
  player.position = {-9, -37};
  player.attention_side = Side::kRight;
  player.attention_unum = 4;
  EXPECT_EQ(show_of_first_player(player),
            "(show 0 ((b) 0 0 0 0) ((l 1) 0 0 -9 -37 0 0 0 0 (v h 90) (fp 0 0) (s 8000 1 1 130600) "
            "(c 0 0 0 0 0 0 0 0 0 0 0 0))");
}

TEST(RcgText, RoundsLengthsAnglesAndStaminaSeparately) {
  PlayerFrame player = standing();
  player.state = 0x140803;
  player.position = {-50.58973, 0.00004};
  player.velocity = {-0.00004, 0.00005};  // half to even
  player.body = 165.2104;
  player.neck = -12.3456;
  player.pointing_at = {10.00012, -3.14159};
  player.high_quality = false;
  player.view_width = 45;
  player.stamina = 6107.0712345;
  player.effort = 0.9800414;
  player.capacity = 130552.4;

  EXPECT_EQ(show_of_first_player(player),
            "(show 0 ((b) 0 0 0 0) ((l 1) 0 0x140803 -50.5897 0 -0 0 165.21 -12.346 10.0001 "
            "-3.1416 (v l 45) (fp 0 0) (s 6107.07 0.980041 1 130552) (c 0 0 0 0 0 0 0 0 0 0 0 0))");
}

TEST(RcgText, WritesPenaltiesOfBothTeamsAfterFirstKick) {
  TeamFrames teams = {TeamFrame{"HELIOS_L", 0, 0, 0}, TeamFrame{"HELIOS_R", 0, 0, 0}};
  std::string line;
  append_team(1, teams, line);
  teams[0].penalty_missed = 1;
  append_team(481, teams, line);
  EXPECT_EQ(line, "(team 1 HELIOS_L HELIOS_R 0 0)\n(team 481 HELIOS_L HELIOS_R 0 0 0 1 0 0)\n");
}

TEST(RcgText, ReplacesLineFeedsInMessages) {
  std::string line;
  append_message(7, 1, "(referee a\nb \"c\")", line);
  EXPECT_EQ(line, "(msg 7 1 \"(referee a b \"c\")\")\n");
}

TEST(RcgWriter, WritesNothingBeforeKickOffAndOneFrameAfterTimeOver) {
  base::StringSink sink;
  RcgWriter writer(sink);
  Frame frame;
  frame.mode = PlayMode::kBeforeKickOff;
  writer.write_step(frame);
  EXPECT_EQ(sink.bytes(), "");

  frame.time = 6000;
  frame.mode = PlayMode::kTimeOver;
  writer.write_step(frame);
  const auto lines = tests::split_lines(sink.bytes());
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "(playmode 6000 time_over)");
  EXPECT_EQ(lines[1], "(team 6000 null null 0 0)");
  EXPECT_TRUE(lines[2].starts_with("(show 6000 "));

  writer.write_step(frame);
  EXPECT_EQ(tests::split_lines(sink.bytes()).size(), 3u);
}

TEST(RcgWriter, SkipsPlayModesBetweenFrames) {
  base::StringSink sink;
  RcgWriter writer(sink);
  Frame frame;
  frame.mode = PlayMode::kPlayOn;
  writer.write_step(frame);
  frame.mode = PlayMode::kBeforeKickOff;

  writer.write_step(frame);
  frame.mode = PlayMode::kPlayOn;
  writer.write_step(frame);
  int modes = 0;
  for (const auto line : tests::split_lines(sink.bytes())) modes += line.starts_with("(playmode");
  EXPECT_EQ(modes, 1);
}

TEST(MatchName, IncludesScoresAndDecidingPenalties) {
  TeamFrames teams = {TeamFrame{"HELIOS_L", 0, 2, 2}, TeamFrame{"HELIOS_R", 0, 4, 0}};
  EXPECT_EQ(match_name(teams), "HELIOS_L_0_2-vs-HELIOS_R_0_4");
  teams[0].score = 1;
  EXPECT_EQ(match_name(teams), "HELIOS_L_1-vs-HELIOS_R_0");
  teams[1] = {};
  EXPECT_EQ(match_name(teams), "HELIOS_L_1-vs-null");
}

TEST(WithoutLocalPaths, ResetsOnlyFoldersFilesAndCommands) {
  soccer::ServerParams params;
  params.game_log_dir = "/somewhere";
  params.landmark_file = "/somewhere/else";
  params.team_l_start = "./start.sh";
  params.half_time = 20;
  const soccer::ServerParams shown = without_local_paths(params);

  EXPECT_EQ(shown.game_log_dir, "./");
  EXPECT_EQ(shown.landmark_file, "~/.rcssserver-landmark.xml");
  EXPECT_EQ(shown.team_l_start, "");
  EXPECT_EQ(shown.half_time, 20);
}

}  // namespace
}  // namespace cls::gamelog
