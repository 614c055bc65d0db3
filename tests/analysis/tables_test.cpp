// The tables of matches: the bytes of rcg2csv, and the events of scripted matches.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "analysis/play/flow.h"
#include "analysis/play/passes.h"
#include "analysis/tables/log_tables.h"
#include "analysis/tables/tracking_table.h"
#include "base/io/byte_sink.h"
#include "base/text/fnv1a.h"
#include "tests/gamelog/recorded_match.h"
#include "tests/gamelog/scripted_match.h"

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using tests::left;
using tests::record_of;
using tests::right;
using tests::ScriptedMatch;

std::string tracking(const gamelog::MatchRecord& record,
                     TrackingColumns columns = TrackingColumns::kAll) {
  base::StringSink sink;
  TrackingTable table(sink, columns);
  for (std::size_t i = 0; i < record.frames(); ++i) table.on_frame(record, i);
  return sink.bytes();
}

std::string row(const std::string& table, std::size_t number) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < number; ++i) start = table.find('\n', start) + 1;
  return table.substr(start, table.find('\n', start) - start);
}

std::ptrdiff_t cells(const std::string& line) { return std::ranges::count(line, ',') + 1; }

struct Published {
  const char* log;
  std::size_t tracking_size;
  std::uint64_t tracking_hash;
  std::uint64_t types_hash;
};

// Sizes and hashes of what rcg2csv of librcsc (13 March 2025) writes for the fixtures.
constexpr Published kOfRcg2csv[] = {
    {"rcg-v4-excerpt", 41364, 0x2c59024a6ea4121b, 0x9d1bae87c3c8368e},
    {"rcg-v5-excerpt", 40807, 0x4e258636f7835734, 0x9d1bae87c3c8368e},
    {"rcg-v6-excerpt", 30881, 0x403d779e43dc54f9, 0x9d1bae87c3c8368e},
    {"rcg-json-excerpt", 66269, 0xc78e782c2b69aa48, 0x9d1bae87c3c8368e},
    {"team-graphic-v6-excerpt", 7567, 0x66dcdf6dafa62708, 0xa6dac9aedb0f838a},
    {"team-graphic-json-excerpt", 7502, 0x8791b4a7e08441fd, 0xdb45e57394e47fbb},
    {"recorded-messages-excerpt", 33766, 0x5a2527ab2e5ebc24, 0x570e249891ef383a},
    {"match-start", 344541, 0xbeedbca000167fb4, 0x7d93cd401526f61c},
};

TEST(TrackingTable, HasTheBytesOfRcg2csv) {
  for (const Published& expected : kOfRcg2csv) {
    SCOPED_TRACE(expected.log);
    const gamelog::MatchRecord record = record_of(expected.log);
    const std::string table = tracking(record);
    EXPECT_EQ(table.size(), expected.tracking_size);
    EXPECT_EQ(base::fnv1a(table), expected.tracking_hash);
    EXPECT_EQ(base::fnv1a(player_type_table(record)), expected.types_hash);
  }
}

TEST(TrackingTable, PublishedColumnsLackViewWidthAndStamina) {
  const gamelog::MatchRecord record = record_of("rcg-v6-excerpt");
  const std::string all = tracking(record);
  const std::string published = tracking(record, TrackingColumns::kPublished);
  EXPECT_EQ(cells(row(all, 0)), 212);
  EXPECT_EQ(cells(row(all, 9)), 212);
  EXPECT_EQ(cells(row(published, 0)), 168);
  EXPECT_EQ(cells(row(published, 9)), 168);
  EXPECT_THAT(row(published, 0), EndsWith("r11_body,r11_neck"));
  EXPECT_THAT(row(published, 0), HasSubstr(",l1_neck,l2_t,"));
  EXPECT_THAT(row(all, 0), HasSubstr(",l1_neck,l1_vwidth,l1_stamina,l2_t,"));
}

TEST(TrackingTable, CellsOfAbsentValuesAreEmpty) {
  ScriptedMatch match;
  match.player(left(2)).state = 0;
  match.step();
  match.record().version = gamelog::RcgVersion::kV6;
  const std::string table = tracking(match.record());

  EXPECT_EQ(cells(row(table, 2)), 212);
  EXPECT_THAT(row(table, 2), HasSubstr(",120,8000,,,,,,,,,,0,-40,"))
      << "left 2 is not connected: " << row(table, 2);

  // Versions 1 and 2 have places and body angles only.
  match.record().version = gamelog::RcgVersion::kV2;
  const std::string old = row(tracking(match.record()), 1);
  EXPECT_EQ(cells(old), 212);
  EXPECT_THAT(old, StartsWith("1,1,0,\"play_on\",\"A\",0,0,\"B\",0,0,0,0,,,,-50,0,,,0,,,,,-40,"));
}

TEST(TrackingTable, QuotesNamesAndCountsStoppedCycles) {
  ScriptedMatch match;
  match.next().teams[0].name = "a\"\\b";
  match.next().teams[1].name = "";
  match.mode(PlayMode::kFoulChargeLeft);
  match.steps(2);
  match.record().version = gamelog::RcgVersion::kV6;
  const std::string table = tracking(match.record());
  EXPECT_THAT(row(table, 2), StartsWith(R"(2,1,1,"foul_charge_l","a\"\\b",0,0,"null",0,0,0,0,)"));
  EXPECT_THAT(row(table, 3), StartsWith("3,1,2,"));
  match.record().version = gamelog::RcgVersion::kJson;
  EXPECT_THAT(row(tracking(match.record()), 2), HasSubstr(R"(,"",0,0,0,0,)"));
}

TEST(TrackingTable, HasTheHeightOfTheBallBehindAllOtherColumns) {
  ScriptedMatch match;
  match.next().ball_height = 1.5;
  match.step();
  const std::string table = tracking(match.record());
  EXPECT_THAT(row(table, 0), EndsWith(",r11_stamina,b_z"));
  EXPECT_THAT(row(table, 1), EndsWith(",8000,0"));
  EXPECT_THAT(row(table, 2), EndsWith(",8000,1.5"));
}

TEST(TrackingTable, IsEmptyWithoutFrames) {
  EXPECT_EQ(tracking({}), "");
  EXPECT_EQ(player_type_table({}), "");
}

std::string events(const ScriptedMatch& match) { return event_table(build_flow(match.record())); }

constexpr const char* kEventHeading =
    "Type,Side1,Unum1,Time1,Mode1,X1,Y1,Side2,Unum2,Time2,X2,Y2,Success\n";

TEST(EventTable, PairsTouchesOfALivePhase) {
  ScriptedMatch match;
  match.kick(left(5), {1, 0});
  match.kick(left(6), {1, 0});
  ++match.player(left(6)).counts.dash;
  match.kick(left(6), {1, 0});
  match.kick(left(6), {1, 0});  // without a dash: still the same touch
  match.tackle(left(6), {1, 0});
  match.tackle(left(7), {1, 0});
  match.kick(right(8), {0, 0});

  EXPECT_EQ(events(match), std::string(kEventHeading) +
                               "Pass,left,5,1,play_on,0,0,left,6,2,1,0,true\n"
                               "Dribble,left,6,2,play_on,1,0,left,6,3,2,0,true\n"
                               "BallTouch,left,6,4,play_on,3,0,left,6,5,4,0,false\n"
                               "Pass,left,6,5,play_on,4,0,left,7,6,5,0,false\n"
                               "Interception,left,7,6,play_on,5,0,right,8,7,6,0,true\n");
}

TEST(EventTable, CountsTheSamePassesAsTheStatistics) {
  ScriptedMatch match;
  match.player(left(6)).position = {0.5, 0};
  match.step();
  match.kick(left(5), {0.1, 0});
  match.kick(left(6), {0.1, 0});
  match.kick(left(7), {0, 0});
  EXPECT_EQ(events(match), std::string(kEventHeading) +
                               "BallTouch,left,5,2,play_on,0,0,left,6,3,0.1,0,false\n"
                               "Pass,left,6,3,play_on,0.1,0,left,7,4,0.2,0,true\n");

  const Flow flow = build_flow(match.record());
  EXPECT_EQ(find_passes(flow, {}).size(), 1U);
}

TEST(EventTable, SeveralTouchersHaveNoNumber) {
  ScriptedMatch match;
  match.kick(left(5), {1, 0});
  ++match.player(left(6)).counts.kick;
  match.kick(left(7), {1, 0});
  match.kick(left(5), {1, 0});  // no event: who kicked before is unknown
  ++match.player(left(5)).counts.kick;
  match.kick(right(9), {1, 0});
  EXPECT_EQ(events(match), std::string(kEventHeading) +
                               "Pass,left,5,1,play_on,0,0,left,-1,2,1,0,false\n"
                               "MultiTouch,left,5,3,play_on,2,0,neutral,-1,4,3,0,false\n");
}

TEST(EventTable, EndsAtLinesAndGoals) {
  ScriptedMatch match;
  match.kick(right(4), {0, -1});
  match.mode(PlayMode::kKickInLeft);
  match.step();
  match.mode(PlayMode::kPlayOn);
  match.kick(left(2), {1, 0});
  match.mode(PlayMode::kGoalLeft);
  match.step();
  match.mode(PlayMode::kKickOffRight);
  match.step();
  match.mode(PlayMode::kPlayOn);
  match.kick(right(3), {1, 0});
  match.mode(PlayMode::kGoalLeft);
  match.step();
  const std::string table = events(match);

  EXPECT_THAT(table, HasSubstr("OutOfBounds,right,4,1,play_on,0,0,neutral,-1,3,0,-1.94,false\n"));
  EXPECT_THAT(table, HasSubstr("Shoot,left,2,3,kick_in_l,0,-1.94,neutral,-1,4,"));
  EXPECT_THAT(table, HasSubstr("OwnGoal,right,3,"));
  EXPECT_THAT(table, Not(HasSubstr("Interception"))) << "play stood in between: " << table;
}

}  // namespace
}  // namespace cls::analysis
