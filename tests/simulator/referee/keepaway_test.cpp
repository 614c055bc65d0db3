// Keepaway: episodes in a small area instead of a match (docs/spec/simulation-model.md 10.3).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Player;

soccer::ServerParams keepaway_params() {
  return noise_free_params([](auto& server) { server.keepaway = true; });
}

/// Three keepers and two takers, in the first episode.
class Keepaway : public ::testing::Test {
 protected:
  Keepaway() : stage(keepaway_params()) {
    for (int i = 0; i < 3; ++i) stage.add(Side::kLeft, {-5.0 * i, 0});
    for (int i = 0; i < 2; ++i) stage.add(Side::kRight, {5.0 * i + 1, 5});
    stage.step();
    stage.take_calls();
  }

  int episode() const { return stage.world.referee.keepaway.episode; }
  Player& keeper(int unum) { return stage.world.player(Side::kLeft, unum); }
  Player& taker(int unum) { return stage.world.player(Side::kRight, unum); }

  void hold_ball(Player& player, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      stage.place(player, {0, 0});
      stage.place_ball({0.6, 0});
      stage.step();
    }
  }

  Stage stage;
};

TEST_F(Keepaway, PlacesKeepersTakersAndBallInCorners) {
  EXPECT_EQ(episode(), 1);
  expect_near(stage.world.ball.position, {-6, -6});
  int corners = 0;
  for (int unum = 1; unum <= 3; ++unum) {
    const Vec2 place = keeper(unum).position;
    EXPECT_TRUE(std::fabs(place.x) >= 7 && std::fabs(place.x) <= 10);
    EXPECT_TRUE(std::fabs(place.y) >= 7 && std::fabs(place.y) <= 10);
    corners |= 1 << ((place.x > 0 ? 1 : 0) + (place.y > 0 ? 2 : 0));
  }
  EXPECT_EQ(corners, 1 | 2 | 8);  // all but the corner of the takers
  for (int unum = 1; unum <= 2; ++unum) {
    EXPECT_TRUE(taker(unum).position.x <= -7 && taker(unum).position.y >= 7);
  }
}

TEST_F(Keepaway, EndsEpisodeWhenBallLeavesArea) {
  stage.place_ball({9.9, 0}, {0.05, 0});
  stage.step();
  EXPECT_EQ(episode(), 1);
  stage.place_ball({9.9, 0}, {0.3, 0});
  keeper(1).stamina.value = 1000;
  stage.step();
  EXPECT_EQ(episode(), 2);
  EXPECT_EQ(stage.take_calls(), Calls{"13 training Keepaway 1"});
  expect_near(stage.world.ball.position, {-6, -6});
  EXPECT_EQ(keeper(1).stamina.value, 8000);
}

TEST_F(Keepaway, EndsEpisodeAfterFourCyclesOfTakerPossession) {
  hold_ball(taker(1), 4);
  EXPECT_EQ(episode(), 1);
  hold_ball(taker(1), 1);
  EXPECT_EQ(episode(), 2);
}

TEST_F(Keepaway, KeeperAtBallResetsPossessionCount) {
  hold_ball(taker(1), 3);
  stage.place(taker(1), {5, 5});
  hold_ball(keeper(1), 1);
  stage.place(keeper(1), {-5, -5});
  hold_ball(taker(1), 4);
  EXPECT_EQ(episode(), 1);
}

TEST_F(Keepaway, CallsNoFouls) {
  stage.world.random = simulator::RandomStreams(1);
  for (int i = 0; i < 20; ++i) {
    stage.place(keeper(1), {5, 0});
    stage.place(taker(1), {4.2, 0});
    stage.place_ball({5.6, 0});
    stage.command(taker(1), "(tackle 0 true)");
    stage.step(11);
  }
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
}

TEST(KeepawayStart, StartsByKickOffOrAfterKeepawayStart) {
  soccer::ServerParams server = keepaway_params();
  server.keepaway_start = 2;  // seconds
  simulator::World world = make_match(server);
  simulator::Events events;
  for (int i = 0; i < 19; ++i) simulator::step(world, events);
  EXPECT_EQ(world.mode, PlayMode::kBeforeKickOff);
  simulator::step(world, events);
  EXPECT_EQ(world.mode, PlayMode::kPlayOn);

  world = make_match(keepaway_params());
  for (int i = 0; i < 100; ++i) simulator::step(world, events);
  EXPECT_EQ(world.mode, PlayMode::kBeforeKickOff);
  simulator::kick_off(world, events);
  EXPECT_EQ(world.mode, PlayMode::kPlayOn);
}

}  // namespace
}  // namespace cls::tests
