// One step from each state recorded by rcssserver must lead to the next recorded state.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "gamelog/record/record_builder.h"
#include "tests/simulator/replay/replayed_logs.h"
#include "tests/support/files.h"

namespace cls::simulator {
namespace {

using gamelog::MatchRecord;
using gamelog::RclRecord;
using testing::HasSubstr;

void expect_same_game(const LogAgreement& agreement) {
  EXPECT_GT(agreement.mode.steps, 0);
  EXPECT_TRUE(agreement.game_misses.empty()) << all_misses(agreement);
  EXPECT_TRUE(agreement.missing_calls.empty()) << all_misses(agreement);
  EXPECT_TRUE(agreement.extra_calls.empty()) << all_misses(agreement);
  EXPECT_EQ(agreement.skipped, 0);
}

// The whole match is not in the repository; its first 395 cycles are.
TEST(Replay, MatchesRcssserverInExcerptWithoutNoise) {
  const LogAgreement agreement = replay(read_logs(tests::fixture("simulator/noise-free")));
  EXPECT_FALSE(agreement.has_noise);
  EXPECT_EQ(agreement.ball.steps, 424);
  EXPECT_EQ(agreement.players.steps, 22 * 424);
  EXPECT_EQ(agreement.agreed(), agreement.steps()) << all_misses(agreement);
  expect_same_game(agreement);
}

TEST(Replay, MatchesRcssserverInMatchWithoutNoise) {
  const auto game = tests::data("noise-free/game.rcg.gz");
  if (!game) GTEST_SKIP() << "no data: set CLS_DATA";
  const LogAgreement agreement = replay(read_logs(game->parent_path() / "game"));
  EXPECT_EQ(agreement.ball.steps, 2158);
  EXPECT_EQ(agreement.players.steps, 47476);
  EXPECT_EQ(agreement.agreed(), agreement.steps()) << all_misses(agreement);
  expect_same_game(agreement);

  // Random tackles and fouls, and half time with its 23 objects.
  EXPECT_LT(agreement.excused_share(), 0.001);
  EXPECT_EQ(agreement.uncounted, 0);
  EXPECT_EQ(agreement.by_cause[static_cast<std::size_t>(Excuse::kHalfTime)], 23);

  for (const StepClass contact :
       {StepClass::kBallKick, StepClass::kBallTackle, StepClass::kBallCatch, StepClass::kBallHeld,
        StepClass::kBallCollision, StepClass::kPlayerCollision, StepClass::kPlayerPlaced,
        StepClass::kPlayerMove}) {
    EXPECT_GT(agreement.by_class[static_cast<std::size_t>(contact)].steps, 0) << name(contact);
  }
}

// The player farthest from all other objects, which can be moved without a collision.
Slot loneliest(const MatchRecord& game, std::size_t frame) {
  Slot best = 0;
  double most = 0.0;
  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const auto at = [&](Slot other) -> Vec2 {
      return game.players.position[frame * gamelog::kSlots + static_cast<std::size_t>(other)];
    };
    double nearest = distance(at(slot), game.ball_position[frame]);
    for (Slot other = 0; other < soccer::kPlayersOnPitch; ++other) {
      if (other != slot) nearest = std::min(nearest, distance(at(slot), at(other)));
    }
    if (nearest > most) std::tie(most, best) = std::pair{nearest, slot};
  }
  return best;
}

bool is_lonely_ball(const MatchRecord& game, std::size_t frame) {
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const Vec2 player = game.players.position[frame * gamelog::kSlots + slot];
    if (distance(player, game.ball_position[frame]) < 3.0) return false;
  }
  return true;
}

TEST(Replay, ReportsExactlyTheStepsOfShiftedRecords) {
  Logs logs = read_logs(tests::fixture("simulator/noise-free"));
  using Place = std::tuple<int, int, Slot>;
  std::set<Place> expected;
  int shifted = 0;

  for (std::size_t frame = 2; frame + 2 < logs.game.frames() && shifted < 100; frame += 3) {
    const auto in_play = [&](std::size_t i) { return logs.game.mode[i] == PlayMode::kPlayOn; };
    if (!in_play(frame - 1) || !in_play(frame) || !in_play(frame + 1)) continue;
    const bool of_ball = shifted % 4 == 0 && is_lonely_ball(logs.game, frame);
    const Slot slot = of_ball ? kNoPlayer : loneliest(logs.game, frame);
    gamelog::Point& place =
        of_ball
            ? logs.game.ball_position[frame]
            : logs.game.players.position[frame * gamelog::kSlots + static_cast<std::size_t>(slot)];
    place.x += 0.01f;
    ++shifted;
    for (const std::size_t i : {frame, frame + 1}) {
      expected.insert({logs.game.time[i], logs.game.stopped[i], slot});
    }
  }

  ASSERT_EQ(shifted, 100);
  const LogAgreement agreement = replay(logs);
  std::set<Place> reported;

  for (const Miss& miss : agreement.misses) {
    reported.insert({miss.clock.time, miss.clock.stoppage, miss.slot});
  }

  EXPECT_EQ(reported, expected) << all_misses(agreement);
  EXPECT_EQ(agreement.steps() - agreement.agreed(), static_cast<int>(expected.size()));
}

TEST(Replay, ReportsStepWithOneWrongValue) {
  Logs logs = read_logs(tests::fixture("simulator/noise-free"));
  const std::size_t frame = 200;
  const std::size_t entry = frame * gamelog::kSlots + 4;
  logs.game.players.body[entry] += 1.0f;
  logs.game.players.stamina[entry + 1] += 1.0f;
  logs.game.players.state[entry + 2] ^= state::kTackle;
  const LogAgreement agreement = replay(logs);
  ASSERT_GE(agreement.misses.size(), 2u);
  EXPECT_EQ(agreement.misses[0].slot, 4);
  EXPECT_EQ(agreement.misses[0].what.substr(0, 5), "body ");
  EXPECT_EQ(agreement.misses[1].slot, 5);
  EXPECT_EQ(agreement.misses[1].what.substr(0, 8), "stamina ");
  EXPECT_EQ(agreement.state.misses(), 1);
}

TEST(Replay, SkipsGapsBetweenFrames) {
  const Logs logs = read_logs(tests::fixture("simulator/noise-free"));
  MatchRecord cut = logs.game;
  gamelog::resize_frames(cut, 200);
  gamelog::RecordBuilder builder(cut);
  for (std::size_t i = 210; i < 310; ++i) builder.append_frame(frame_at(logs.game, i));

  const LogAgreement agreement = replay({cut, logs.text});
  EXPECT_EQ(agreement.skipped, 1);
  EXPECT_EQ(agreement.ball.steps, 298);
  EXPECT_EQ(agreement.agreed(), agreement.steps()) << all_misses(agreement);
}

/// Matches with default noise, one of them with extra time and a shoot-out.
class NoisyReplay : public ::testing::TestWithParam<const char*> {};

void expect_uniform(const NoiseSample& sample, std::size_t least) {
  ASSERT_GE(sample.shares.size(), least);
  const double root = std::sqrt(static_cast<double>(sample.shares.size()));
  EXPECT_NEAR(sample.mean(), 0.5, 4.0 * std::sqrt(1.0 / 12.0) / root);
  EXPECT_LE(sample.distance_to_uniform(), 2.2 / root);
  EXPECT_LE(sample.largest(), 1.02);  // rounding
}

TEST_P(NoisyReplay, MatchesRefereeCallsWithPlausibleNoise) {
  const auto game = tests::data(std::string(GetParam()) + ".rcg.gz");
  if (!game) GTEST_SKIP() << "no data: set CLS_DATA";
  const LogAgreement agreement = replay(read_logs(game->parent_path() / game->stem().stem()));
  EXPECT_TRUE(agreement.has_noise);
  expect_same_game(agreement);
  EXPECT_EQ(agreement.agreed(), agreement.steps()) << all_misses(agreement);
  EXPECT_LE(agreement.uncounted, agreement.steps() / 500);
  expect_uniform(agreement.player_noise, 1000);
  if (agreement.kick_noise.n < 300) return;
  expect_uniform(agreement.ball_noise, 1000);
  EXPECT_NEAR(agreement.kick_noise.mean(), 1.0, 4.0 * std::sqrt(0.8 / agreement.kick_noise.n));
}

INSTANTIATE_TEST_SUITE_P(Logs, NoisyReplay,
                         ::testing::Values("logs/helios-vs-helios-full",
                                           "logs/cyrus-vs-helios-full",
                                           "logs/extra-time-and-penalties",
                                           "logs/recorded-messages", "logs/rcg-v6",
                                           "aligned/game"));

TEST(Replay, RejectsUnusableLogs) {
  const Logs logs = read_logs(tests::fixture("simulator/noise-free"));
  const auto message = [](const MatchRecord& game, const RclRecord& text) {
    const auto agreement = replay_log(game, text);
    return agreement ? std::string() : agreement.error().message;
  };
  MatchRecord old = logs.game;
  old.version = gamelog::RcgVersion::kV2;
  EXPECT_THAT(message(old, logs.text), HasSubstr("lack the precision"));

  MatchRecord short_one = logs.game;
  gamelog::resize_frames(short_one, 1);
  EXPECT_THAT(message(short_one, logs.text), HasSubstr("fewer than two frames"));

  RclRecord strangers = logs.text;
  for (std::string& team : strangers.teams) team += "_B";
  EXPECT_THAT(message(logs.game, strangers), HasSubstr("no messages of the teams of the game log"));
  RclRecord later = logs.text;
  for (gamelog::RclLine& line : later.lines) line.time += 500;
  EXPECT_THAT(message(logs.game, later), HasSubstr("of different matches"));
}

}  // namespace
}  // namespace cls::simulator
