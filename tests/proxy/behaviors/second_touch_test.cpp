// The taker of a set play does not touch the ball twice.
#include <gtest/gtest.h>

#include "player/behaviors/behaviors.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using protos::PlayerActions;
using soccer::PlayMode;
using soccer::Side;
using soccer::Vec2;
using tests::KnownPitch;

const auto kSetPlay = [](PlayerActions& reply) { reply.add_actions()->mutable_helios_set_play(); };
const auto kWithBall = [](PlayerActions& reply) {
  auto& planner = *reply.add_actions()->mutable_helios_offensive_planner();
  planner.set_direct_pass(true);
  planner.set_short_dribble(true);
};
const auto kWithoutBall = [](PlayerActions& reply) {
  reply.add_actions()->mutable_helios_basic_move();
};

/// The agent has just taken our free kick; the ball rolls past its teammates.
KnownPitch after_free_kick(Vec2 ball, Vec2 velocity) {
  KnownPitch pitch;
  pitch.place_ball(ball, velocity);
  pitch.add_teammate(9, {14.0, 6.0}, 180.0);
  pitch.add_opponent(2, {25.0, 0.0});
  pitch.world.last_kick = {Side::kLeft, 7};
  pitch.memory.set_play_kick.cycle = pitch.world.game.time.cycle - 1;
  return pitch;
}

bool touches(const KnownPitch& pitch) {
  return pitch.sent<soccer::Kick>() != nullptr || pitch.sent<soccer::Tackle>() != nullptr;
}

TEST(SecondTouch, IsRememberedFromOurSetPlay) {
  KnownPitch pitch;
  pitch.set_mode(PlayMode::kFreeKickLeft);
  pitch.place_ball({0.6, 0.0});
  pitch.add_teammate(9, {14.0, 6.0}, 180.0);
  pitch.world.unum = set_play_kicker(pitch.world);
  pitch.world.game.last_set_play_start = -1000;  // it is time to kick
  const int cycles = pitch.act_until(30, kSetPlay, [&] { return touches(pitch); });
  ASSERT_LT(cycles, 30) << "the free kick was not taken";
  EXPECT_GE(pitch.memory.set_play_kick.cycle, 0);
}

TEST(SecondTouch, LeavesRollingBall) {
  KnownPitch pitch = after_free_kick({0.5, 0.0}, {1.0, 0.3});
  ASSERT_TRUE(pitch.world.self.kickable);
  pitch.act(kWithBall);
  EXPECT_FALSE(touches(pitch));
  EXPECT_EQ(pitch.sent<soccer::Dash>(), nullptr);
}

TEST(SecondTouch, DoesNotChaseTheBall) {
  KnownPitch pitch = after_free_kick({3.0, 0.0}, {0.3, 0.0});
  pitch.act(kWithoutBall);
  EXPECT_FALSE(touches(pitch));
  KnownPitch open_play = after_free_kick({3.0, 0.0}, {0.3, 0.0});
  open_play.memory.set_play_kick = {};
  for (int i = 0; i < 20; ++i) open_play.act(kWithoutBall);
  for (int i = 0; i < 20; ++i) pitch.act(kWithoutBall);
  EXPECT_LT(distance(open_play.world.self.position, open_play.world.ball.position), 1.2);
  EXPECT_GT(distance(pitch.world.self.position, pitch.world.ball.position), 1.5);
}

TEST(SecondTouch, RepeatsKickThatFailedBeforeTheFirstDash) {
  KnownPitch pitch = after_free_kick({0.6, 0.0}, {0.05, 0.0});
  pitch.act(kWithBall);
  EXPECT_TRUE(touches(pitch));
  KnownPitch dashed = after_free_kick({0.6, 0.0}, {0.05, 0.0});
  dashed.memory.set_play_kick.dashed = true;
  dashed.act(kWithBall);
  EXPECT_FALSE(touches(dashed));
}

TEST(SecondTouch, IsAllowedAfterAnotherPlayersTouch) {
  KnownPitch pitch = after_free_kick({0.5, 0.0}, {-0.2, 0.0});
  pitch.memory.set_play_kick.dashed = true;
  pitch.world.last_kick = {Side::kLeft, 9};
  pitch.act(kWithBall);
  EXPECT_TRUE(touches(pitch));
  EXPECT_LT(pitch.memory.set_play_kick.cycle, 0);
}

TEST(SecondTouch, IsAllowedWhenTheBallIsNotFetched) {
  KnownPitch pitch = after_free_kick({0.5, 0.0}, {-0.2, 0.0});
  pitch.memory.set_play_kick = {pitch.world.game.time.cycle - 50, true};
  pitch.act(kWithBall);
  EXPECT_TRUE(touches(pitch));
}

}  // namespace
}  // namespace cls::proxy
