// Files of the Common Data Format against its schemas.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "analysis/tables/cdf_match.h"
#include "base/io/byte_sink.h"
#include "base/text/json.h"
#include "base/text/lines.h"
#include "tests/analysis/plays.h"
#include "tests/gamelog/recorded_match.h"
#include "tests/support/files.h"
#include "tests/support/json_schema.h"

namespace cls::analysis {
namespace {

using json = base::Json;
using soccer::PlayMode;
using testing::ElementsAre;
using testing::IsEmpty;
using tests::left;
using tests::right;
using tests::ScriptedMatch;

std::vector<std::string> errors_of(const std::string& kind, const json& document) {
  const auto path = tests::fixture("cdf/" + kind + ".schema.json");
  return tests::schema_errors(json::parse(tests::read_file(path)), document);
}

std::vector<json> lines_of(const std::string& text) {
  std::vector<json> lines;
  for (const std::string_view line : base::lines_of(text)) lines.push_back(json::parse(line));
  return lines;
}

std::vector<json> tracking_of(const CdfMatch& match) {
  base::StringSink sink;
  write_cdf_tracking(match, sink);
  return lines_of(sink.bytes());
}

void expect_members(const json& object, const json& expected) {
  for (const auto& [key, value] : expected.items()) EXPECT_EQ(object[key], value) << key;
}

void expect_schemas(const gamelog::MatchRecord& record) {
  const CdfMatch match(record, "a/b");
  EXPECT_THAT(errors_of("match", json::parse(cdf_match_document(match))), IsEmpty());
  EXPECT_THAT(errors_of("meta", json::parse(cdf_meta_document(match))), IsEmpty());
  for (const json& event : lines_of(cdf_events(match))) {
    ASSERT_THAT(errors_of("event", event), IsEmpty()) << event.dump();
  }
  const std::vector<json> frames = tracking_of(match);
  EXPECT_EQ(frames.size(), record.frames());
  for (const json& frame : frames)
    ASSERT_THAT(errors_of("tracking", frame), IsEmpty()) << frame.dump();
}

TEST(Cdf, RecordedMatchesFitTheSchemas) {
  for (const char* name :
       {"rcg-v1-excerpt", "rcg-v3-excerpt", "rcg-v6-excerpt", "rcg-json-excerpt", "match-start"}) {
    SCOPED_TRACE(name);
    expect_schemas(tests::record_of(name));
  }
}

TEST(Cdf, PlayersStartWhoAreThereWhenPlayBegins) {
  ScriptedMatch played;
  played.steps(3);
  gamelog::MatchRecord& record = played.record();
  record.mode[0] = PlayMode::kBeforeKickOff;  // before the teams connect
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) record.players.state[slot] = 0;
  record.players.state[gamelog::kSlots] = 0;  // the left goalie comes a frame after the others
  const CdfMatch match(record, "a");
  const json players = json::parse(cdf_match_document(match))["teams"]["home"]["players"];
  ASSERT_EQ(players.size(), 11U);
  EXPECT_EQ(players[0]["is_starter"], false);
  EXPECT_EQ(players[1]["is_starter"], true);
}

TEST(Cdf, EmptyAndNamelessMatchesFitTheSchemas) {
  expect_schemas({});
  ScriptedMatch nameless;
  nameless.next().teams = {};
  nameless.steps(3);
  expect_schemas(nameless.record());
}

// The schemas do not accept everything.
TEST(Cdf, SchemasFindErrors) {
  EXPECT_THAT(errors_of("tracking", json::object()), testing::Not(IsEmpty()));

  ScriptedMatch match;
  const auto errors_with = [&](auto change) {
    json frame = tracking_of(CdfMatch(match.record(), "m"))[0];
    change(frame);
    return errors_of("tracking", frame);
  };

  EXPECT_THAT(errors_with([](json& frame) { frame["ball"]["x"] = "0"; }),
              ElementsAre("/ball/x: must be [\"number\",\"null\"]"));
  EXPECT_THAT(errors_with([](json& frame) { frame["period"] = "third_half"; }),
              ElementsAre("/period: not in the enum"));
  EXPECT_THAT(errors_with([](json& frame) { frame["teams"]["home"]["players"].back().erase("y"); }),
              ElementsAre("/teams/home/players/10: lacks \"y\""));
}

TEST(Cdf, FramesHaveThePitchAroundTheOriginAndUpwards) {
  ScriptedMatch match;
  match.player(right(11)).position = {3, 4};
  match.player(right(11)).velocity = {0.3, -0.4};
  match.player(left(2)).state = 0;
  match.kick(left(5), {1, 0.5});
  const CdfMatch cdf(match.record(), "m");
  const json frame = tracking_of(cdf)[1];

  expect_members(frame, {{"frame_id", 1},
                         {"timestamp", "1970-01-01T00:00:00.100Z"},
                         {"period", "first_half"},
                         {"match", {{"id", "m"}}},
                         {"ball_status", true},
                         {"ball_poss_team_id", "A"},
                         {"ball", {{"x", 1}, {"y", -0.5}, {"z", 0}}}});
  EXPECT_EQ(frame["teams"]["home"]["players"].size(), 10u) << "left 2 is not connected";
  EXPECT_EQ(frame["teams"]["away"]["players"][10],
            (json{{"id", "B_11"}, {"x", 3}, {"y", -4}, {"vel", 5}}));
}

TEST(Cdf, EventsHaveReceiversAndFrames) {
  ScriptedMatch match;
  match.kick(left(5), {1, 0});
  match.step();
  match.kick(left(6), {0.1, 0});
  const CdfMatch cdf(match.record(), "m");
  const std::vector<json> events = lines_of(cdf_events(cdf));

  ASSERT_EQ(events.size(), 1u);

  expect_members(events[0]["event"], {{"id", "m_0"},
                                      {"type", "pass"},
                                      {"is_successful", true},
                                      {"player_id", "A_5"},
                                      {"receiver_id", "A_6"},
                                      {"receiver_time", "1970-01-01T00:00:00.300Z"},
                                      {"match_clock", "00:00.20"}});
  EXPECT_EQ(events[0]["tracking"], (json{{"frame_id", 1}, {"frame_id_end", 3}}));
}

// Positions are floats, whose digits as doubles mean nothing.
TEST(Cdf, EventsHaveTheDigitsOfTheLog) {
  ScriptedMatch match;
  match.kick(left(5), {0.1, 0.7});
  match.kick(left(6), {0.1, 0});
  const CdfMatch cdf(match.record(), "m");
  EXPECT_THAT(cdf_events(cdf), testing::HasSubstr(R"("x_end":0.1,"y_end":-0.7,)"));
}

TEST(Cdf, DocumentsHavePeriodsGoalsAndResult) {
  ScriptedMatch match;
  match.record().server.half_time = 1;
  match.record().notes.push_back(
      {0, 0, 0, gamelog::Message{1, "(result 202607301415 A_1-vs-B_0)"}});
  match.steps(12);
  kick_from(match, {45, 0}, left(9), {2.7, 0});
  match.steps(3);
  score_goal(match, soccer::Side::kLeft);
  match.mode(PlayMode::kTimeOver);
  match.step();
  const CdfMatch cdf(match.record(), "m");
  const json sheet = json::parse(cdf_match_document(cdf));
  const json& result = sheet["match"]["result"];

  expect_members(result, {{"final", {{"home", 1}, {"away", 0}}},
                          {"first_half", {{"home", 0}, {"away", 0}}},
                          {"second_half", {{"home", 1}, {"away", 0}}},
                          {"final_winning_team_id", "A"}});
  ASSERT_EQ(sheet["events"]["goals"].size(), 1u);
  EXPECT_EQ(sheet["events"]["goals"][0]["player_id"], "A_9");
  EXPECT_EQ(sheet["events"]["goals"][0]["period"], "second_half");

  const json meta = json::parse(cdf_meta_document(cdf));
  EXPECT_EQ(meta["match"]["kickoff_time"], "2026-07-30T14:15:00.000Z");
  ASSERT_EQ(meta["match"]["periods"].size(), 2u);
  EXPECT_EQ(meta["match"]["periods"][1]["frame_id_start"], 10);
  EXPECT_EQ(meta["match"]["whistles"].size(), 4u);
  EXPECT_EQ(meta["meta"]["tracking"]["fps"], 10);
}

}  // namespace
}  // namespace cls::analysis
