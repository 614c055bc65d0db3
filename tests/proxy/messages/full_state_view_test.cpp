// World models with the full state of the server.
#include "proxy/messages/full_state_view.h"

#include <gtest/gtest.h>

#include "player/perception/perception.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using soccer::FullState;
using soccer::FullStatePlayer;
using soccer::Side;
using tests::KnownPitch;

FullStatePlayer player(Side side, int unum, soccer::Vec2 position) {
  FullStatePlayer one;
  one.side = side;
  one.unum = unum;
  one.position = position;
  return one;
}

FullState state() {
  FullState full;
  full.ball_position = {11.0, 2.0};
  full.ball_velocity = {1.0, -0.5};
  full.players = {player(Side::kLeft, 7, {10.0, 2.0}), player(Side::kLeft, 9, {20.0, 5.0}),
                  player(Side::kRight, 2, {30.0, -5.0}), player(Side::kRight, 1, {50.0, 0.0})};
  full.players[0].body = 30.0;
  full.players[0].neck = -10.0;
  full.players[2].velocity = {0.25, 0.0};
  full.players[2].type = 3;
  full.players[3].goalie = true;
  return full;
}

TEST(FullStateView, ReplacesEstimates) {
  KnownPitch pitch;
  pitch.add_teammate(9, {0.0, 0.0}, 0.0, 20);
  pitch.add_opponent(5, {1.0, 1.0});
  const player::WorldModel exact = full_state_view(pitch.world, state());

  EXPECT_EQ(exact.self.position, (soccer::Vec2{10.0, 2.0}));
  EXPECT_EQ(exact.self.face().degrees(), 20.0);
  EXPECT_EQ(exact.ball.relative_position, (soccer::Vec2{1.0, 0.0}));
  ASSERT_EQ(exact.teammates.size(), 1U) << "without the agent";
  EXPECT_EQ(exact.teammates[0].position, (soccer::Vec2{20.0, 5.0}));
  EXPECT_EQ(exact.teammates[0].pos_count, 0);
  EXPECT_EQ(exact.teammates[0].id, pitch.world.teammates[0].id) << "the same player";
  ASSERT_EQ(exact.opponents.size(), 2U) << "number 5 is not on the pitch";
  EXPECT_EQ(exact.opponents[0].unum, 1) << "by number";
  EXPECT_TRUE(exact.opponents[0].goalie);
  EXPECT_EQ(exact.opponents[1].type_id, 3);
  EXPECT_EQ(exact.opponents[1].velocity, (soccer::Vec2{0.25, 0.0}));
}

TEST(FullStateView, RotatesForATeamOnTheRight) {
  KnownPitch pitch;
  pitch.world.our_side = Side::kRight;
  pitch.world.unum = 2;
  const player::WorldModel exact = full_state_view(pitch.world, state());
  EXPECT_EQ(exact.self.position, (soccer::Vec2{-30.0, 5.0}));
  EXPECT_EQ(exact.ball.position, (soccer::Vec2{-11.0, -2.0}));
  EXPECT_EQ(exact.ball.velocity, (soccer::Vec2{-1.0, 0.5}));
  ASSERT_EQ(exact.opponents.size(), 2U);
  EXPECT_EQ(exact.opponents[0].unum, 7);
  EXPECT_EQ(exact.opponents[0].body.degrees(), -150.0);
}

TEST(FullStateView, CanBeCompleted) {
  KnownPitch pitch;
  player::WorldModel exact = full_state_view(pitch.world, state());
  update_derived(exact);
  EXPECT_LT(exact.intercept.best_self_steps(), player::kNever);
  EXPECT_EQ(exact.their_goalie_unum, 1);
}

}  // namespace
}  // namespace cls::proxy
