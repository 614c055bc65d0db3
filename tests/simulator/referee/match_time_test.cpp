// Halves, extra time, and the automatic kick-off (docs/spec/simulation-model.md 9.3, 9.6, 9.16).
#include <gtest/gtest.h>

#include "simulator/step.h"
#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Player;
using BeforeTheFirstKickOff = OnStage;

// Halves and extra halves of ten cycles.
soccer::ServerParams tiny_match() {
  return noise_free_params([](auto& server) {
    server.half_time = 1;
    server.extra_half_time = 1;
  });
}

class MatchTime : public ::testing::Test {
 protected:
  explicit MatchTime(const soccer::ServerParams& server = tiny_match()) : stage(server) {
    stage.add(Side::kLeft, {-30, 0});
    stage.add(Side::kRight, {30, 0});
    stage.world.clock = {};
    stage.set_mode(PlayMode::kBeforeKickOff);
    kick_off();
    stage.take_calls();
  }

  void kick_off() { simulator::kick_off(stage.world, stage.events); }

  void play_half() {
    stage.set_mode(PlayMode::kPlayOn);
    stage.take_calls();
    stage.step_until_mode_changes();
  }

  Stage stage;
};

TEST_F(MatchTime, AlternatesKickOffsAndExtendsDraw) {
  play_half();
  EXPECT_EQ(stage.take_calls(), (Calls{"10 half_time", "10 before_kick_off"}));
  EXPECT_EQ(stage.world.clock, (simulator::Clock{10, 0}));

  kick_off();
  EXPECT_EQ(stage.world.mode, PlayMode::kKickOffRight);
  play_half();
  EXPECT_EQ(stage.take_calls(), (Calls{"20 time_extended", "20 before_kick_off"}));

  kick_off();
  EXPECT_EQ(stage.world.mode, PlayMode::kKickOffLeft);
  play_half();
  EXPECT_EQ(stage.take_calls(), (Calls{"30 time_extended", "30 before_kick_off"}));
  kick_off();
  EXPECT_EQ(stage.world.mode, PlayMode::kKickOffRight);
  stage.world.team(Side::kLeft).score = 1;
  play_half();
  EXPECT_EQ(stage.take_calls(), (Calls{"40 time_up", "40 time_over"}));
  stage.step(3);
  EXPECT_EQ(stage.world.clock, (simulator::Clock{40, 3}));
}

TEST_F(MatchTime, EndsAfterNormalTimeWithWinner) {
  play_half();
  kick_off();
  stage.world.team(Side::kRight).score = 2;
  play_half();
  EXPECT_EQ(stage.take_calls(), (Calls{"20 time_up", "20 time_over"}));
}

TEST_F(MatchTime, AcceptsKickOffOnlyAtStartOfHalf) {
  stage.set_mode(PlayMode::kPlayOn);
  stage.step(3);
  stage.take_calls();
  kick_off();
  EXPECT_EQ(stage.take_calls(), Calls{});
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
}

TEST_F(MatchTime, RestoresStaminaOnlyInNormalHalves) {
  Player& player = stage.world.player(Side::kLeft, 1);
  const auto tire = [&] {
    player.stamina.value = 3000;
    player.stamina.recovery = 0.7;
    player.stamina.capacity = 100;
  };

  tire();
  play_half();
  tire();
  kick_off();
  EXPECT_EQ(player.stamina.value, 8000);
  EXPECT_EQ(player.stamina.recovery, 1.0);
  EXPECT_EQ(player.stamina.capacity, 130600);

  stage.set_mode(PlayMode::kPlayOn);
  stage.step(9);
  tire();
  stage.step();
  EXPECT_EQ(stage.world.mode, PlayMode::kBeforeKickOff);
  EXPECT_GT(player.stamina.capacity, 130000);

  kick_off();
  EXPECT_LT(player.stamina.value, 4000);
}

TEST_F(MatchTime, MovesPlayersToOwnHalfAtKickOff) {
  Player& left = stage.world.player(Side::kLeft, 1);
  Player& right = stage.world.player(Side::kRight, 1);
  left.position = {20, 5};
  right.position = {2, 1};
  stage.step();
  // Kick-off for the left side: left players stay in their half, right players also leave the
  // circle.
  expect_near(left.position, {-0.3, 5});
  EXPECT_NEAR(right.position.length(), 9.45, 1e-4);
}

// Found in a recorded match whose left team waited at the ball for the first kick-off.
TEST_F(BeforeTheFirstKickOff, AllowsLeftTeamInCenterCircle) {
  stage.world = make_match(noise_free_params());
  Player& left = stage.add(Side::kLeft, {-0.39, 0});
  Player& right = stage.add(Side::kRight, {0.39, 3});
  stage.step();
  expect_near(left.position, {-0.39, 0});
  EXPECT_NEAR(right.position.length(), 9.45, 1e-4);
}

class GoldenGoal : public MatchTime {
 protected:
  static soccer::ServerParams params() {
    soccer::ServerParams server = tiny_match();
    server.golden_goal = true;
    return server;
  }
  GoldenGoal() : MatchTime(params()) {}
};

TEST_F(GoldenGoal, EndsExtraTimeImmediately) {
  play_half();
  kick_off();
  play_half();
  kick_off();
  stage.set_mode(PlayMode::kPlayOn);
  stage.step(2);
  stage.take_calls();
  stage.place_ball({52, 0}, {1, 0});
  stage.world.referee.touch.previous_ball = {52, 0};
  stage.step();
  EXPECT_EQ(stage.take_calls(), (Calls{"23 goal_l_1", "23 time_over"}));
}

class AutoMode : public testing::Test {
 protected:
  AutoMode() {
    stage.world.clock = {};
    stage.set_mode(PlayMode::kBeforeKickOff);
  }

  Stage stage{[](auto& server) { server.auto_mode = true; }};
};

TEST_F(AutoMode, KicksOffHundredStepsAfterLastPlayerConnected) {
  for (int unum = 1; unum <= 11; ++unum) {
    stage.add(Side::kLeft, {-3.0 * unum, -20});
    stage.add(Side::kRight, {3.0 * unum, 20});
  }
  stage.take_calls();
  EXPECT_EQ(stage.step_until_mode_changes(), 100);
  EXPECT_EQ(stage.take_calls(), Calls{"0 kick_off_l"});
}

TEST_F(AutoMode, KicksOffAfterConnectWaitWithMissingPlayers) {
  stage.add(Side::kLeft, {-3, -20});
  EXPECT_EQ(stage.step_until_mode_changes(), 300);
}

TEST_F(AutoMode, EndsAfterGameOverWait) {
  stage.set_mode(PlayMode::kTimeOver);
  stage.step(99);
  EXPECT_FALSE(stage.world.auto_mode.ended);
  stage.step();
  EXPECT_TRUE(stage.world.auto_mode.ended);
}

}  // namespace
}  // namespace cls::tests
