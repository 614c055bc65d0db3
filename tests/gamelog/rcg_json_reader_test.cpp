// JSON logs of servers 17, 18 and 19, and invalid lines.
#include "gamelog/rcg/format_readers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/files.h"

namespace cls::gamelog {
namespace {

using soccer::PlayMode;
using testing::FieldsAre;

MatchRecord read(std::string_view log) {
  base::MemorySource source(log);
  return read_rcg(source);
}

constexpr const char* kPlayer =
    R"({"side":"r","unum":5,"type":3,"state":262145,"x":-1.5,"y":2.25,"vx":-0,"vy":0.5,"body":90.5,)"
    R"("neck":-9,"px":1,"py":2,"vq":"l","vw":60,"stamina":4000.5,"effort":0.9,"recovery":1,)"
    R"("capacity":100,"fside":"l","fnum":7,"kick":1,"dash":2,"turn":3,"catch":4,"move":5,)"
    R"("turn_neck":6,"change_view":7,"say":8,"tackle":9,"pointto":10,"attentionto":11,"change_focus":12})";

std::string show(const std::string& players) {
  return R"({"show":{"time":43,"stime":2,"ball":{"x":3.5697,"y":-0.4629,"vx":-0,"vy":1},"players":[)" +
         players + "]}}";
}

constexpr const char* kEnd = ",\n{\"playmode\":{\"time\":44,\"mode\":\"time_over\"}},\n";

std::string log_of(const std::string& element) {
  return "[\n" + element + kEnd + show(kPlayer) + "\n]\n";
}

// As `jq .` and `jq -c .` write logs: elements over many lines, or all in one.
TEST(ReadRcgJson, ReadsLogsThatOtherProgramsHaveFormatted) {
  const std::string log = "[\n{\"version\":\"19.0.0\"},\n{\"timestamp\":\"2026, \\\"[\"},\n" +
                          show(kPlayer) + kEnd + show(kPlayer) + "\n]\n";
  std::string joined = log;
  std::erase(joined, '\n');
  std::string broken;
  bool in_string = false;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (log[i] == '"' && log[i - 1] != '\\') in_string = !in_string;
    const bool breaks = !in_string && (log[i] == '{' || log[i] == ',' || log[i] == '[');
    broken += log[i];
    if (breaks) broken += "\n  ";
  }

  const MatchRecord whole = read(log);
  ASSERT_TRUE(whole.errors.empty());
  for (const std::string& form : {joined, broken, "\xef\xbb\xbf" + joined}) {
    const auto source = base::decompress(std::make_unique<base::MemorySource>(form));
    const MatchRecord record = read_rcg(*source);
    ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
    EXPECT_EQ(record.frames(), whole.frames());
    EXPECT_EQ(record.timestamp, "2026, \"[");
    EXPECT_EQ(frame_at(record, 0).players[15].body, 90.5);
    EXPECT_EQ(record.version, RcgVersion::kJson);
  }
}

TEST(ReadRcgJson, ReadsAllPlayerMembers) {
  const MatchRecord record = read(log_of(show(kPlayer)));

  ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
  EXPECT_EQ(record.version, RcgVersion::kJson);

  const Frame frame = frame_at(record, 0);
  EXPECT_EQ(frame.time, 43);
  EXPECT_EQ(frame.stopped, 2);
  EXPECT_EQ(static_cast<float>(frame.ball_position.x), 3.5697F);

  const PlayerFrame& p = frame.players[15];
  EXPECT_EQ(p.type, 3);
  EXPECT_EQ(p.state, 0x40001u);
  EXPECT_EQ(p.position, (soccer::Vec2{-1.5, 2.25}));
  EXPECT_EQ(p.velocity.y, 0.5);
  EXPECT_EQ(p.body, 90.5);
  EXPECT_EQ(p.neck, -9);
  EXPECT_EQ(p.pointing_at.value(), (soccer::Vec2{1, 2}));
  EXPECT_FALSE(p.high_quality);
  EXPECT_EQ(p.view_width, 60);
  EXPECT_EQ(p.stamina, 4000.5);
  EXPECT_EQ(p.capacity, 100);
  EXPECT_EQ(p.attention_side, soccer::Side::kLeft);
  EXPECT_EQ(p.attention_unum, 7);
  EXPECT_THAT(p.counts, FieldsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12));
  EXPECT_EQ(frame.players[0].state, 0u);
}

TEST(ReadRcgJson, ReadsOtherElements) {
  const MatchRecord record = read(
      "[\n{\"version\":\"19.0.0\"},\n{\"timestamp\":\"2026-11-20T20:39:55+0000\"},\n"
      "{\"server_param\":{\"auto_mode\":true,\"ball_decay\":0.9,\"half_time\":20,"
      "\"text_log_dir\":\"a(b)\\\\c\"}},\n{\"player_param\":{\"pt_max\":2}},\n"
      "{\"player_type\":{\"id\":1,\"player_decay\":0.3}},\n"
      "{\"team_graphic\":{\"side\":\"r\",\"x\":22,\"y\":3,\"xpm\":[\"8 8 1 1\",\"w c "
      "gray100\"]}},\n"
      "{\"team\":{\"time\":1,\"stime\":4,\"l\":{\"name\":\"A\\\"B\",\"score\":3,\"pen_score\":2,"
      "\"pen_miss\":1},\"r\":{\"name\":null,\"score\":0}}},\n"
      "{\"msg\":{\"time\":60,\"stime\":4,\"board\":2,\"message\":\"(say "
      "\\\"\\u00fc\x01\xff\\\")\"}},\n"
      "{\"news\":{\"a\":[1,{\"b\":null}]}},\n" +
      show(kPlayer) + kEnd + show("") + "\n]\n");

  ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
  EXPECT_EQ(record.server_version, "19.0.0");
  EXPECT_EQ(record.timestamp, "2026-11-20T20:39:55+0000");
  EXPECT_TRUE(record.server.auto_mode);
  EXPECT_EQ(record.server.ball_decay, 0.9);
  EXPECT_EQ(record.server.half_time, 20);
  EXPECT_EQ(record.parameter_lines.at(0),
            "(server_param (auto_mode 1)(ball_decay 0.9)(half_time 20)(text_log_dir \"a(b)\\c\"))");
  EXPECT_EQ(record.player.pt_max, 2);
  EXPECT_EQ(record.types.at(1).player_decay, 0.3);
  EXPECT_EQ(record.final_teams()[0], (TeamFrame{"A\"B", 3, 2, 1}));
  EXPECT_EQ(record.final_teams()[1], TeamFrame{});
  EXPECT_EQ(record.notes[0].time, 0);
  EXPECT_EQ(std::get<Message>(record.notes[0].content).text,
            "(team_graphic_r (22 3 \"8 8 1 1\" \"w c gray100\")");
  EXPECT_EQ(record.notes[1].stopped, 4);
  EXPECT_EQ(std::get<Message>(record.notes[2].content), (Message{2, "(say \"\xc3\xbc\x01\xff\")"}));
  EXPECT_EQ(std::get<UnknownLine>(record.notes[3].content).text,
            "{\"news\":{\"a\":[1,{\"b\":null}]}}");
}

TEST(ReadRcgJson, ReadsTaggedFormOfServers17And18) {
  const std::string player =
      R"({"side":"l","unum":1,"type":0,"state":9,"x":-49,"y":0,"vx":0,"vy":0,"body":1,"neck":2,)"
      R"("vq":"h","vw":120,"stamina":8000,"effort":1,"recovery":1,"capacity":130600,)"
      R"("count":{"kick":1,"dash":2,"turn":3,"count":{"kick":9}}})";

  const std::string elements =
      "{\"type\":\"header\",\"version\":\"18.1.3\",\"timestamp\":\"t\"},\n"
      "{\"type\":\"server_param\",\"params\":{\"half_time\":20}},\n"
      "{\"type\":\"player_type\",\"id\":2,\"params\":{\"player_decay\":0.3}},\n"
      "{\"type\":\"playmode\",\"time\":1,\"mode\":\"kick_off_l\"},\n"
      "{\"type\":\"team\",\"time\":1,\"teams\":[{\"side\":\"l\",\"name\":\"A\",\"score\":1},"
      "{\"side\":\"r\",\"name\":\"B\",\"score\":2}]},\n"
      "{\"type\":\"show\",\"time\":1,\"ball\":{\"x\":1,\"y\":0,\"vx\":0,\"vy\":0},\"players\":[" +
      player + "]},\n{\"type\":\"playmode\",\"time\":2,\"mode\":\"time_over\"},\n" + show("") +
      "\n]\n";

  for (const char* header : {"ULG6\n", "JSON\n", ""}) {
    const MatchRecord record = read(header + ("[\n" + elements));
    ASSERT_TRUE(record.errors.empty()) << format_error("", record.errors.first[0]);
    EXPECT_EQ(record.version, RcgVersion::kJson);
    EXPECT_EQ(record.server_version, "18.1.3");
    EXPECT_EQ(record.server.half_time, 20);
    EXPECT_EQ(record.types.at(2).player_decay, 0.3);
    EXPECT_EQ(record.mode[0], PlayMode::kKickOffLeft);
    EXPECT_EQ(record.final_teams()[1], (TeamFrame{"B", 2}));
    EXPECT_EQ(record.players.counters[0][2], 3);
    EXPECT_EQ(record.players.view_width[0], 120.0F);
  }
}

TEST(ReadRcgJson, ReportsInvalidLinesAndReadsTheRest) {
  for (const char* bad :
       {"{\"show\":{\"time\":43", "{\"msg\":{\"time\":1,\"board\":1,\"message\":\"half", "nonsense",
        "{\"show\":{\"time\":-1}}", "{\"team\":5}", "{}", "{\"playmode\":{\"time\":x}}",
        "{\"show\":{\"time\":1,\"players\":[{\"side\":\"l\",\"unum\":12}]}}",
        "{\"msg\":{\"time\":-2147483648 1,\"board\":1,\"message\":\"\"}}",
        "{\"player_type\":{\"id\":900}}", "{\"playmode\":{\"time\":1,\"mode\":\"play_on\"}} x"}) {
    const std::string before = "[\n" + show(kPlayer) + ",\n";
    const MatchRecord record = read(before + bad + kEnd + show(kPlayer) + "\n]\n");
    EXPECT_EQ(record.frames(), 2u) << bad;
    ASSERT_EQ(record.errors.count, 1u) << bad;
    EXPECT_EQ(record.errors.first[0].line, 3u);
    EXPECT_GE(record.errors.first[0].byte, before.size());
  }
}

TEST(ReadRcgJson, ReportsMissingClosingBracket) {
  const MatchRecord record = read("[\n" + show(kPlayer) + kEnd + show(kPlayer) + ",\n");
  EXPECT_EQ(record.frames(), 2u);
  ASSERT_EQ(record.errors.count, 1u);
  EXPECT_EQ(record.errors.first[0].message, "closing bracket missing: the log is incomplete");
}

TEST(ReadRcgJson, SurvivesDeepNesting) {
  const MatchRecord record = read("[\n{\"x\":{\"a\":" + std::string(100000, '[') +
                                  "\n{\"y\":{\"a\":" + std::string(100000, '{'));
  EXPECT_GE(record.errors.count, 2u);
}

TEST(ReadRcgJson, UsesRecordedStoppedClock) {
  // The text reader counts repeated times; here the log records them.
  const MatchRecord record =
      read(tests::read_file(tests::fixture("gamelog/rcg-json-excerpt.rcg.gz")));
  EXPECT_TRUE(record.errors.empty());
  ASSERT_EQ(record.frames(), 52u);

  int stopped = 0;
  for (std::size_t i = 1; i < record.frames(); ++i) {
    const int counted = record.time[i] == record.time[i - 1] ? record.stopped[i - 1] + 1 : 0;
    EXPECT_EQ(record.stopped[i], counted) << i;
    stopped += record.stopped[i] > 0;
  }

  EXPECT_GT(stopped, 3);
}

}  // namespace
}  // namespace cls::gamelog
