// Text logs: literal lines, a second reader, and truncation at every byte.
#include "gamelog/rcg/rcg_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/support/files.h"
#include "tests/support/rcg_lines.h"

namespace cls::gamelog {
namespace {

using soccer::PlayMode;
using soccer::Side;
using testing::FieldsAre;

MatchRecord read(std::string_view log) {
  base::MemorySource source(log);
  return read_rcg(source);
}

std::string player(const char* name, const char* rest = "") {
  return std::string(" ((") + name + ") 0 0x1 1 2 0 0 0 0 (v h 120) (fp 0 0) (s 8000 1 1 130600)" +
         rest + " (c 0 0 0 0 0 0 0 0 0 0 0 0))";
}

// A player of an rcssserver show with all values, and twenty-one plain players.
constexpr const char* kFullPlayer =
    " ((l 1) 2 0x40009 -50.5897 -0.0123 -0 0.1 165.21 -89.5 10.0001 -3.1416 (v l 45) (fp 10.5 -20) "
    "(s 6107.07 0.980041 0.998 130552) (f r 11) (c 1 2 3 4 5 6 7 8 9 10 11 12))";

std::string show(int time, const std::string& first_player = player("l 1")) {
  std::string line = "(show " + std::to_string(time) + " ((b) 1.5 -2.5 0.25 -0)" + first_player;
  for (int unum = 2; unum <= 11; ++unum) line += player(("l " + std::to_string(unum)).c_str());
  for (int unum = 1; unum <= 11; ++unum) line += player(("r " + std::to_string(unum)).c_str());
  return line + ")\n";
}

constexpr const char* kEnd = "(playmode 9 time_over)\n";

std::string with_carriage_returns(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

// Mail programs and Windows write them.
TEST(ReadRcg, ReadsLinesThatEndWithCarriageReturns) {
  for (const char* name : {"gamelog/rcg-v5-excerpt.rcg.gz", "gamelog/rcg-v6-excerpt.rcg.gz",
                           "gamelog/rcg-json-excerpt.rcg.gz"}) {
    const std::string log = tests::read_file(tests::fixture(name));
    const MatchRecord expected = read(log);
    const MatchRecord record = read(with_carriage_returns(log));
    EXPECT_EQ(record.errors.count, expected.errors.count) << name;
    EXPECT_EQ(record.version, expected.version);
    ASSERT_EQ(record.frames(), expected.frames()) << name;
    ASSERT_GT(record.frames(), 10u);
    const std::size_t last = record.frames() - 1;
    EXPECT_EQ(frame_at(record, last).players[21].position,
              frame_at(expected, last).players[21].position);
    EXPECT_EQ(frame_at(record, last).players[21].capacity,
              frame_at(expected, last).players[21].capacity);
    EXPECT_EQ(record.final_teams()[0].name, expected.final_teams()[0].name);
    EXPECT_EQ(record.notes.size(), expected.notes.size());
  }
}

TEST(ReadRcg, ReadsAllPlayerValues) {
  const MatchRecord record = read("ULG6\n" + show(7, kFullPlayer) + kEnd + show(9));

  ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
  ASSERT_EQ(record.frames(), 2u);

  const Frame frame = frame_at(record, 0);
  EXPECT_EQ(frame.time, 7);
  EXPECT_EQ(frame.ball_position, (soccer::Vec2{1.5, -2.5}));
  EXPECT_EQ(frame.ball_velocity, (soccer::Vec2{0.25, 0}));
  EXPECT_TRUE(std::signbit(frame.ball_velocity.y));

  const PlayerFrame& p = frame.players[0];
  EXPECT_EQ(p.type, 2);
  EXPECT_EQ(p.state, 0x40009u);
  EXPECT_FLOAT_EQ(static_cast<float>(p.position.x), -50.5897F);
  EXPECT_FLOAT_EQ(static_cast<float>(p.position.y), -0.0123F);
  EXPECT_TRUE(std::signbit(p.velocity.x));
  EXPECT_FLOAT_EQ(static_cast<float>(p.body), 165.21F);
  EXPECT_FLOAT_EQ(static_cast<float>(p.neck), -89.5F);
  ASSERT_TRUE(p.pointing_at);
  EXPECT_FLOAT_EQ(static_cast<float>(p.pointing_at->y), -3.1416F);
  EXPECT_FALSE(p.high_quality);
  EXPECT_EQ(p.view_width, 45);
  EXPECT_EQ(p.focus_distance, 10.5);
  EXPECT_EQ(p.focus_direction, -20);
  EXPECT_FLOAT_EQ(static_cast<float>(p.stamina), 6107.07F);
  EXPECT_FLOAT_EQ(static_cast<float>(p.effort), 0.980041F);
  EXPECT_FLOAT_EQ(static_cast<float>(p.recovery), 0.998F);
  EXPECT_EQ(p.capacity, 130552);
  EXPECT_EQ(p.attention_side, Side::kRight);
  EXPECT_EQ(p.attention_unum, 11);
  EXPECT_THAT(p.counts, FieldsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12));

  EXPECT_FALSE(frame.players[1].pointing_at);
  EXPECT_EQ(frame.players[1].attention_side, Side::kNeutral);
}

TEST(ReadRcg, ReadsVersion4WithoutCapacityFocusAndTwelfthCounter) {
  std::string log = "ULG4\n(show 1 ((b) 0 0 0 0)";
  log +=
      " ((l 1) 0 0x9 -49.2249 -0.174 -0.0899 -0.0696 -140.146 90 (v h 120) (s 8000 1 1) "
      "(c 0 1 123 0 1 125 2 1 0 0 1))";
  const MatchRecord record = read(log + ")\n" + kEnd + show(9));
  EXPECT_EQ(record.version, RcgVersion::kV4);
  ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
  EXPECT_EQ(record.players.capacity[0], -1.0F);
  EXPECT_EQ(record.players.counters[0][2], 123);
  EXPECT_EQ(record.players.counters[0][11], 0);

  // Slots missing in the line are not connected.
  EXPECT_TRUE(is_enabled(record, 0));

  for (std::size_t slot = 1; slot < kSlots; ++slot) EXPECT_EQ(record.players.state[slot], 0u);
}

TEST(ReadRcg, ReadsTheHeightOfVersion7) {
  const auto with_ball = [](const std::string& ball) {
    const std::string line = show(1);
    return line.substr(0, line.find("((b)")) + ball + line.substr(line.find(" ((l 1)"));
  };

  const MatchRecord record =
      read("ULG7\n" + with_ball("((b) 1 2 0 0 1.25)") + with_ball("((b) 1 2 0 0)") +
           with_ball("((b) 1 2 0 0 -0)") + kEnd + show(9));
  ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
  EXPECT_EQ(record.version, RcgVersion::kV7);
  EXPECT_TRUE(record.has_ball_height);
  EXPECT_EQ(std::vector<float>(record.ball_height.begin(), record.ball_height.end()),
            (std::vector<float>{1.25F, 0, 0, 0}));
  EXPECT_EQ(frame_at(record, 0).ball_height, 1.25);

  const MatchRecord older = read("ULG6\n" + with_ball("((b) 1 2 0 0 1.25)") + show(2) + kEnd);
  EXPECT_EQ(older.errors.count, 1u) << "version 6 has no height";
  EXPECT_EQ(older.frames(), 1u);
  EXPECT_FALSE(older.has_ball_height);
  EXPECT_FALSE(frame_at(older, 0).ball_height);
}

TEST(ReadRcg, RefusesUnknownVersionsByNumber) {
  const auto error_of = [](std::string_view log) {
    const MatchRecord record = read(log);
    EXPECT_EQ(record.frames(), 0u);
    return record.errors.first.at(0).message;
  };

  const std::string rest =
      ", which this cls does not know: it reads 1 to 7 and JSON; a newer cls may read it";
  EXPECT_EQ(error_of("ULG8\n" + show(1)), "game log (rcg) of version 8" + rest);
  EXPECT_EQ(error_of("ULG12\r\n" + show(1)), "game log (rcg) of version 12" + rest);
  EXPECT_EQ(error_of("ULG\x05..."), "game log (rcg) of version 5" + rest);

  for (const char* other : {"ULG", "ULG\n", "ULG8", "ULGx\n", "ULG8 of clubs\n", "hello"}) {
    EXPECT_EQ(error_of(other), "not a game log (rcg)") << other;
  }
}

// rcgverconv of librcsc writes versions 4 and 5 with words as switches and "(fl 10)".
TEST(ReadRcg, ReadsTheFormsOfRcgverconv) {
  const std::string listening =
      " ((l 1) 2 0x9 -50 0 0 0 1 2 (v h 90) (s 8000 1 1) (fl 10) (c 1 2 3 4 5 6 7 8 9 10 11))"
      " ((l 2) 2 0x1 -50 0 0 0 1 2 (v h 90) (s 8000 1 1) (fr 3) (c 1 2 3 4 5 6 7 8 9 10 11))";

  const MatchRecord record = read(
      "ULG4\n(server_param (auto_mode true)(use_offside false)(half_time 300))\n"
      "(player_param (allow_mult_default_type true)(player_types 18))\n"
      "(show 1 ((b) 0 0 0 0)" +
      listening + ")\n" + kEnd + show(9));

  ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
  EXPECT_TRUE(record.server.auto_mode);
  EXPECT_FALSE(record.server.use_offside);
  EXPECT_TRUE(record.player.allow_mult_default_type);
  EXPECT_EQ(record.players.attention[0], soccer::slot_of(Side::kLeft, 10));
  EXPECT_EQ(record.players.attention[1], soccer::slot_of(Side::kRight, 3));
  EXPECT_EQ(record.players.counters[1][10], 11);
}

TEST(ReadRcg, CountsStoppedCyclesAndTracksModeAndTeams) {
  const MatchRecord record = read("ULG6\n(playmode 1 kick_off_l)\n(team 1 A B 0 0)\n" + show(1) +
                                  show(2) + "(playmode 2 goal_l)\n(team 2 A B 1 0)\n" + show(2) +
                                  show(2) + "(playmode 3 kick_off_r)\n" + show(3) + kEnd + show(9));

  ASSERT_TRUE(record.errors.empty());
  ASSERT_EQ(record.frames(), 6u);
  EXPECT_EQ(std::vector<int>(record.stopped.begin(), record.stopped.end()),
            (std::vector<int>{0, 0, 1, 2, 0, 0}));
  EXPECT_EQ(record.mode[1], PlayMode::kKickOffLeft);
  EXPECT_EQ(record.mode[2], PlayMode::kGoalLeft);
  EXPECT_EQ(record.mode[4], PlayMode::kKickOffRight);
  EXPECT_EQ(record.teams[record.team_state[1]][0].score, 0);
  EXPECT_EQ(record.teams[record.team_state[2]][0].score, 1);
  EXPECT_EQ(record.final_teams()[1].name, "B");
}

TEST(ReadRcg, StoresMessagesAndUnknownLinesUnchanged) {
  const MatchRecord record = read(
      "ULG6\n(msg 0 1 \"(team_graphic_l (22 3 \"8 8 1 1\" \"w c gray100\")\")\n"
      "(msg 3 2 \"Recv A_1: (say \")\") \xff\xfe\")\n(draw 3 (clear))\n(playmode 3 siesta)\n" +
      show(3) + "(msg 3 1 \"(result 202611202101 A_0-vs-B_0)\")\n");

  ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
  ASSERT_EQ(record.notes.size(), 5u);
  EXPECT_EQ(std::get<Message>(record.notes[0].content),
            (Message{1, "(team_graphic_l (22 3 \"8 8 1 1\" \"w c gray100\")"}));
  EXPECT_EQ(std::get<Message>(record.notes[1].content).text, "Recv A_1: (say \")\") \xff\xfe");
  EXPECT_EQ(std::get<UnknownLine>(record.notes[2].content).text, "(draw 3 (clear))");
  EXPECT_EQ(std::get<UnknownLine>(record.notes[3].content).text, "(playmode 3 siesta)");
  EXPECT_EQ(record.notes[4].frame, 1u);
}

TEST(ReadRcg, ReadsAllTeamNamesAllowedByServer) {
  for (const char* name :
       {"A-vs-B", "A_1", "T,1:2_3", "a.b", "Coach", "^\\[]@", "\xc3\xbc\xe2\x9a\xbd"}) {
    const MatchRecord record =
        read("ULG6\n(team 1 " + std::string(name) + " null 2 0 3 1 2 2)\n" + kEnd + show(9));
    ASSERT_TRUE(record.errors.empty()) << name;
    EXPECT_EQ(record.final_teams()[0], (TeamFrame{name, 2, 3, 1}));
    EXPECT_EQ(record.final_teams()[1], (TeamFrame{"", 0, 2, 2}));
  }
}

using Names = std::pair<std::string, std::string>;

TEST(ReadRcg, SplitsNamesWithSpacesByResult) {
  const auto names = [](const std::string& both, const std::string& result) {
    const MatchRecord record = read(
        "ULG6\n(team 1 " + both + " 2 1)\n" + show(1) + "(team 2 " + both + " 3 1)\n" + show(2) +
        "(msg 2 1 \"(result 202611202127 " + result + ")\")\n(team 2 " + both + " 3 1 4 0 2 2)\n");
    EXPECT_TRUE(record.errors.empty()) << both;
    EXPECT_EQ(record.teams[1][0].name, record.final_teams()[0].name);
    EXPECT_EQ(record.teams[1][0].score, 2);
    EXPECT_EQ(record.final_teams()[0].score, 3);
    EXPECT_EQ(record.final_teams()[0].penalty_scored, 4);
    EXPECT_EQ(record.final_teams()[1].penalty_missed, 2);
    return Names(record.final_teams()[0].name, record.final_teams()[1].name);
  };

  EXPECT_EQ(names("my team B", "my team_3-vs-B_1"), Names("my team", "B"));
  EXPECT_EQ(names("A B C D E", "A_3-vs-B C D E_1"), Names("A", "B C D E"));
  EXPECT_EQ(names("Team 1 Team 2", "odd"), Names("Team 1", "Team 2"));
  EXPECT_EQ(names("null my team", ""), Names("", "my team"));
  EXPECT_EQ(names("A-vs-B C  D null", ""), Names("A-vs-B C  D", ""));

  const std::string long_name(80, 'M');
  EXPECT_EQ(names("A " + long_name, ""), Names("A", long_name.substr(0, 64)));
  EXPECT_FALSE(
      read("ULG6\n(team 1 my team -2147483648 0)\n" + std::string(kEnd) + show(9)).errors.empty());
  EXPECT_FALSE(read("ULG6\n(team 1 my team 0 0)\n(team 1 a b c)\n" + std::string(kEnd) + show(9))
                   .errors.empty());
}

TEST(ReadRcg, ReadsMonitorShowsAndRepeatedSpaces) {
  const MatchRecord record = read("ULG5\n(show 4 (pm 3) (tm A B 0 0)  ((b)  1 2  0 0)  " +
                                  player("l 1") + "  " + player("r 3") + " )\n" + kEnd + show(9));
  ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
  EXPECT_TRUE(is_enabled(record, 0));
  EXPECT_TRUE(is_enabled(record, 13));
}

TEST(ReadRcg, ReportsCorruptLineAndReadsTheRest) {
  std::string broken = show(2);
  const std::size_t at = broken.find("8000");
  broken[at] = 'x';
  const std::string before = "ULG6\n" + show(1);
  const MatchRecord record = read(before + broken + show(3) + kEnd + show(9));

  EXPECT_EQ(record.frames(), 3u);
  ASSERT_EQ(record.errors.count, 1u);
  EXPECT_EQ(format_error("game.rcg", record.errors.first[0]),
            "game.rcg: line 3, byte " + std::to_string(before.size() + at) +
                ", cycle 1: expected a number");
  EXPECT_EQ(record.time[1], 3);
}

TEST(ReadRcg, RejectsInvalidShows) {
  const std::string whole = show(2);
  struct Case {
    const char* old;
    const char* with;
  };

  for (const auto& [old, with] :
       {Case{"((l 2)", "((l 1)"}, Case{"((l 2)", "((l 12)"}, Case{"((l 2)", "((n 2)"},
        Case{"0x1 1", "0x 1"}, Case{"0x1 1", "0x123456789 1"}, Case{"0x1 1", "1 1"},
        Case{"(v h", "(v x"}, Case{"0 0))", "0 0)"}, Case{"0 0))", "0 0 0))"},
        Case{"0 0 0 0))", "0 0))"}, Case{"1.5 ", "nano "}, Case{"1.5 ", "1e12x "},
        Case{"1.5 ", "- "}, Case{"1.5 ", "infinity "}, Case{"(show 2", "(show -2"},
        Case{" 0 0x1", " 300 0x1"}}) {
    std::string broken = whole;
    broken.replace(broken.find(old), std::string(old).size(), with);
    const MatchRecord record = read("ULG6\n" + show(1) + broken + kEnd + show(9));
    EXPECT_EQ(record.errors.count, 1u) << old << " -> " << with;
    EXPECT_EQ(record.frames(), 2u) << old << " -> " << with;
  }
}

// rcssserver prints such numbers for a player that points very far away.
TEST(ReadRcg, RetainsFramesWithNumbersOutOfRange) {
  struct Case {
    const char* text;
    float value;
  };

  for (const auto& [text, value] :
       {Case{"inf", 1e9F}, Case{"-inf", -1e9F}, Case{"nan", 0.0F}, Case{"-nan", 0.0F},
        Case{"-3.37711e+38", -1e9F}, Case{"1e+12", 1e9F}, Case{"1e999", 1e9F}}) {
    std::string far = player("l 1");
    far.replace(far.find("0 (v h"), 1, "0 " + std::string(text) + " 1.6418e+08");
    const std::string before = "ULG6\n" + show(1);
    const MatchRecord record = read(before + show(2, far) + kEnd + show(9));
    ASSERT_EQ(record.frames(), 3u) << text;
    EXPECT_EQ(record.players.pointing_at[kSlots].x, value) << text;
    EXPECT_EQ(record.players.pointing_at[kSlots].y, 1.6418e8F) << text;
    EXPECT_EQ(record.ball_position[1].x, 1.5F) << text;
    ASSERT_EQ(record.errors.count, 1u) << text;
    EXPECT_EQ(format_error("game.rcg", record.errors.first[0]),
              "game.rcg: line 3, byte " + std::to_string(before.size() + show(2, far).find(text)) +
                  ", cycle 2: number out of range");
  }
}

TEST(ReadRcg, ReportsLogWithoutEndOfMatch) {
  const MatchRecord interrupted = read("ULG6\n(playmode 1 play_on)\n" + show(1) + show(2));
  EXPECT_EQ(interrupted.frames(), 2u);
  ASSERT_EQ(interrupted.errors.count, 1u);
  EXPECT_EQ(interrupted.errors.first[0].message, "no end of the match: the log is incomplete");
  EXPECT_EQ(interrupted.errors.first[0].cycle, 2);

  // Ended by its operator before time: complete, but short.
  const MatchRecord ended =
      read("ULG6\n" + show(1) + "(msg 1 1 \"(result 202611202101 null-vs-null)\")\n");
  EXPECT_TRUE(ended.errors.empty());
}

TEST(ReadRcg, RejectsOtherFiles) {
  for (const char* text : {"", "ULG6", "ULG9\n", "hello\n", "{}", "(show 1)\n"}) {
    const MatchRecord record = read(text);
    EXPECT_EQ(record.frames(), 0u) << text;
    EXPECT_GE(record.errors.count, 1u) << text;
  }
}

TEST(ReadRcg, ReadsUpToTruncation) {
  const std::string log = tests::read_file(tests::fixture("gamelog/rcg-v6-excerpt.rcg.gz"));
  const MatchRecord whole = read(log);

  ASSERT_TRUE(whole.errors.empty());

  for (std::size_t size = 0; size < log.size(); size += size < 2000 || size % 7 == 0 ? 1 : 97) {
    const MatchRecord record = read(std::string_view(log).substr(0, size));
    const std::size_t lines = static_cast<std::size_t>(
        std::count(log.begin(), log.begin() + static_cast<long>(size), '\n'));
    ASSERT_LE(record.frames(), whole.frames());
    ASSERT_GE(record.frames() + record.notes.size() + record.parameter_lines.size() + 1, lines);
    if (record.frames() > 0) {
      ASSERT_EQ(record.time.back(), whole.time[record.frames() - 1]);
    }
    if (record.frames() + 1 < whole.frames()) {
      ASSERT_GE(record.errors.count, 1u) << size;
    }
  }
}

/// Compares with everything that tests::read_frames finds (independent, slow and strict).
void expect_same_frames(const std::string& log) {
  const MatchRecord record = read(log);

  ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);

  const std::vector<Frame> expected = tests::read_frames(log);
  ASSERT_EQ(record.frames(), expected.size());

  const auto same = [](double a, double b) {
    return static_cast<float>(a) == static_cast<float>(b);
  };

  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Frame& a = expected[i];
    const Frame b = frame_at(record, i);
    ASSERT_TRUE(a.time == b.time && a.mode == b.mode && a.teams == b.teams) << i;
    ASSERT_TRUE(same(a.ball_position.x, b.ball_position.x) &&
                same(a.ball_velocity.y, b.ball_velocity.y));
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      const PlayerFrame& p = a.players[slot];
      const PlayerFrame& q = b.players[slot];
      ASSERT_TRUE(p.type == q.type && p.state == q.state && same(p.position.x, q.position.x) &&
                  same(p.position.y, q.position.y) && same(p.velocity.x, q.velocity.x) &&
                  same(p.velocity.y, q.velocity.y) && same(p.body, q.body) &&
                  same(p.neck, q.neck) && p.pointing_at.has_value() == q.pointing_at.has_value() &&
                  p.high_quality == q.high_quality && same(p.view_width, q.view_width) &&
                  same(p.focus_distance, q.focus_distance) &&
                  same(p.focus_direction, q.focus_direction) && same(p.stamina, q.stamina) &&
                  same(p.effort, q.effort) && same(p.recovery, q.recovery) &&
                  same(p.capacity, q.capacity) && p.attention_side == q.attention_side &&
                  p.attention_unum == q.attention_unum)
          << "frame " << i << " slot " << slot;
      if (p.pointing_at) {
        ASSERT_TRUE(same(p.pointing_at->x, q.pointing_at->x));
      }
      ASSERT_EQ(std::memcmp(&p.counts, &q.counts, sizeof p.counts), 0) << i;
    }
  }
}

TEST(ReadRcg, MatchesStrictReaderOnExcerpt) {
  expect_same_frames(tests::read_file(tests::fixture("gamelog/rcg-v6-excerpt.rcg.gz")));
}

TEST(ReadRcg, MatchesStrictReaderOnWholeMatches) {
  for (const char* name : {"helios-vs-helios-full", "cyrus-vs-helios-full",
                           "extra-time-and-penalties", "rcg-v6", "team-graphic-v6"}) {
    const auto path = tests::data("logs/" + std::string(name) + ".rcg.gz");
    if (!path) GTEST_SKIP() << "no data: set CLS_DATA";
    SCOPED_TRACE(name);
    expect_same_frames(tests::read_file(*path));
  }
}

TEST(ReadRcgFile, ReportsMissingFile) {
  EXPECT_EQ(read_rcg_file("/nonexistent/game.rcg").error().message,
            "cannot open '/nonexistent/game.rcg': No such file or directory");
}

}  // namespace
}  // namespace cls::gamelog
