// Binary logs compared with values from an independent decoder in another language.
#include "gamelog/rcg/format_readers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/files.h"

namespace cls::gamelog {
namespace {

using soccer::PlayMode;
using soccer::Vec2;
using testing::FieldsAre;

MatchRecord read(std::string_view log) {
  base::MemorySource source(log);
  return read_rcg(source);
}

std::string excerpt(const char* name) {
  return tests::read_file(tests::fixture(std::string("gamelog/") + name + "-excerpt.rcg.gz"));
}

std::vector<std::string> messages(const MatchRecord& record) {
  std::vector<std::string> result;
  for (const Note& note : record.notes) {
    if (const auto* message = std::get_if<Message>(&note.content)) result.push_back(message->text);
  }
  return result;
}

TEST(ReadRcgVersion1, ReadsShowsAndMessages) {
  const MatchRecord record = read(excerpt("rcg-v1"));
  EXPECT_EQ(record.version, RcgVersion::kV1);
  EXPECT_TRUE(record.errors.empty());
  ASSERT_EQ(record.frames(), 59u);
  EXPECT_EQ(messages(record).front(), "(referee kick_off_l)");
  EXPECT_EQ(messages(record).back(), "(result 202611202100 HELIOS_L_1-vs-HELIOS_R_0)");

  const Frame early = frame_at(record, 11);
  EXPECT_EQ(early.time, 12);
  EXPECT_EQ(early.mode, PlayMode::kKickOffLeft);
  EXPECT_EQ(early.teams[0].name, "HELIOS_L");
  EXPECT_EQ(early.players[0].state, 9u);
  EXPECT_EQ(early.players[0].body, 91);
  EXPECT_EQ(early.players[0].position, (Vec2{-791 / 16.0, -3 / 16.0}));
  EXPECT_EQ(early.players[20].body, -163);
  EXPECT_EQ(early.players[20].position, (Vec2{142 / 16.0, -191 / 16.0}));

  const Frame last = frame_at(record, 58);
  EXPECT_EQ(last.time, 400);
  EXPECT_EQ(last.mode, PlayMode::kTimeOver);
  EXPECT_EQ(last.ball_position, (Vec2{-818 / 16.0, -444 / 16.0}));
  EXPECT_EQ(record.final_teams()[0].score, 1);
}

TEST(ReadRcgVersion2, ReadsShowsWithStoppedClock) {
  const MatchRecord record = read(excerpt("rcg-v2"));
  EXPECT_EQ(record.version, RcgVersion::kV2);
  EXPECT_TRUE(record.errors.empty());
  ASSERT_EQ(record.frames(), 63u);

  const Frame playing = frame_at(record, 30);
  EXPECT_EQ(playing.time, 31);
  EXPECT_EQ(playing.mode, PlayMode::kPlayOn);
  EXPECT_EQ(playing.ball_position, (Vec2{5, 35 / 16.0}));

  const Frame stopped = frame_at(record, 59);
  EXPECT_EQ(stopped.time, 31);
  EXPECT_EQ(stopped.stopped, 29);
  EXPECT_EQ(stopped.mode, PlayMode::kFoulChargeRight);
  EXPECT_EQ(stopped.players[20].body, -12);
  EXPECT_EQ(messages(record).back(), "(result 202611202101 HELIOS_L_0-vs-HELIOS_R_0)");
}

TEST(ReadRcgVersion3, ReadsParametersAndTypes) {
  const MatchRecord record = read(excerpt("rcg-v3"));

  EXPECT_EQ(record.version, RcgVersion::kV3);
  EXPECT_TRUE(record.errors.empty());
  EXPECT_EQ(record.server.half_time, 20);
  EXPECT_EQ(record.server.ball_decay, 0.94);
  EXPECT_EQ(record.server.tackle_width, 1.25);
  EXPECT_TRUE(record.server.synch_mode);
  EXPECT_EQ(record.server.point_to_duration, 20);
  EXPECT_EQ(record.player.player_types, 18);
  EXPECT_EQ(record.player.random_seed, 7);
  EXPECT_EQ(record.player.kick_rand_delta_factor, 1.0);
  ASSERT_EQ(record.types.size(), 18u);
  EXPECT_EQ(record.types[5].id, 5);
  EXPECT_NEAR(record.types[5].stamina_inc_max, 41.984466552734375, 1e-12);
  EXPECT_NEAR(record.types[5].catchable_area_l_stretch, 1.2812957763671875, 1e-12);
  EXPECT_EQ(record.parameter_lines.size(), 20u);
}

TEST(ReadRcgVersion3, ReadsShowsInDegreesAndReorderedCounters) {
  const MatchRecord record = read(excerpt("rcg-v3"));

  ASSERT_EQ(record.frames(), 63u);

  const Frame frame = frame_at(record, 44);
  EXPECT_EQ(frame.time, 45);
  EXPECT_EQ(frame.mode, PlayMode::kPlayOn);
  EXPECT_NEAR(frame.ball_position.x, 4.2203826904296875, 5e-5);
  EXPECT_NEAR(frame.ball_velocity.y, 0.5459747314453125, 5e-5);

  const PlayerFrame& p = frame.players[20];
  EXPECT_EQ(p.type, 7);
  EXPECT_EQ(p.state, 1u);
  EXPECT_NEAR(p.position.y, -22.492828369140625, 5e-5);
  EXPECT_NEAR(p.velocity.x, -0.113128662109375, 5e-5);
  EXPECT_NEAR(p.body, -114.53910317333894, 5e-4);
  EXPECT_EQ(p.neck, -90);
  EXPECT_EQ(p.view_width, 120);
  EXPECT_TRUE(p.high_quality);
  EXPECT_NEAR(p.stamina, 7243.707565307617, 1e-3);
  EXPECT_EQ(p.capacity, -1);
  EXPECT_THAT(p.counts, FieldsAre(0, 39, 104, 0, 1, 144, 7, 6, 0, 0, 0, 0));
  EXPECT_EQ(record.final_teams()[1].name, "HELIOS_R");
}

TEST(ReadRcgBinary, ReadsRecordsBeforeTruncation) {
  for (const char* name : {"rcg-v1", "rcg-v2", "rcg-v3"}) {
    const std::string log = excerpt(name);
    const std::size_t frames = read(log).frames();
    for (const std::size_t size : {log.size() - 1, log.size() / 2, log.size() / 3 + 1}) {
      const MatchRecord record = read(std::string_view(log).substr(0, size));
      EXPECT_GE(record.errors.count, 1u) << name;
      EXPECT_EQ(record.errors.first.at(0).line, 0u);
      EXPECT_LE(record.errors.first.at(0).byte, size);
      EXPECT_LE(record.frames(), frames);
      EXPECT_GE(record.frames() + 1, frames * size / log.size() * 9 / 10) << name;
    }
  }
}

TEST(ReadRcgBinary, StopsAtUnknownRecordKind) {
  std::string log = excerpt("rcg-v2");
  log[4 + 318 * 10 + 1] = 9;
  const MatchRecord record = read(log);
  EXPECT_EQ(record.frames(), 10u);
  EXPECT_EQ(format_error("a.rcg", record.errors.first.at(0)),
            "a.rcg: byte 3184, cycle 10: unknown record kind 9");
}

TEST(ReadRcgVersion1, ReadsSixteenCharacterNamesAndEmptyNames) {
  std::string log = excerpt("rcg-v1").substr(2052, 2052);
  const std::string name = "ABCDEFGHIJKLMNOP";
  std::copy(name.begin(), name.end(), log.begin() + 4);
  std::fill_n(log.begin() + 22, 16, '\0');
  const MatchRecord record = read(log);
  ASSERT_EQ(record.frames(), 1u);
  EXPECT_EQ(record.final_teams()[0].name, name);
  EXPECT_EQ(record.final_teams()[1], TeamFrame{});
}

}  // namespace
}  // namespace cls::gamelog
