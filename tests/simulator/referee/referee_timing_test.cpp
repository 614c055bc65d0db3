// Timing of the referee messages of rcssserver 19.0.0 (docs/spec/simulation-model.md 14.4, 9.5).
#include <gtest/gtest.h>

#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Player;
using RefereeTiming = OnStage;

TEST_F(RefereeTiming, KicksOffFiftyOneStepsAfterGoal) {
  stage.place_ball({51.5, 0}, {2, 0});
  stage.step();
  EXPECT_EQ(stage.take_calls(), (Calls{"11 goal_l_1"}));
  EXPECT_EQ(stage.world.mode, PlayMode::kGoalLeft);
  EXPECT_EQ(stage.world.team(Side::kLeft).score, 1);
  expect_near(stage.world.ball.velocity, {0, 0}, 0.0);
  EXPECT_EQ(stage.step_until_mode_changes(), 51);
  EXPECT_EQ(stage.take_calls(), (Calls{"11 kick_off_r"}));
  EXPECT_EQ(stage.world.clock, (simulator::Clock{12, 0}));
  expect_near(stage.world.ball.position, {0, 0}, 0.0);
}

TEST_F(RefereeTiming, DropsBallWhenKickOffIsNotTaken) {
  stage.world.clock.time = 0;
  stage.set_mode(PlayMode::kBeforeKickOff);
  simulator::kick_off(stage.world, stage.events);
  EXPECT_EQ(stage.world.mode, PlayMode::kKickOffLeft);
  stage.take_calls();
  EXPECT_EQ(stage.step_until_mode_changes(), 100);
  EXPECT_EQ(stage.take_calls(), (Calls{"100 drop_ball", "100 play_on"}));
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
}

// A left player passes; another one, ahead of all players, tries to kick and misses.
class OffsideTiming : public ::testing::Test {
 protected:
  OffsideTiming()
      : passer(stage.add(Side::kLeft, {9.4, 0})), runner(stage.add(Side::kLeft, {20, 0})) {
    stage.add(Side::kRight, {5, 30});
    stage.add(Side::kRight, {4, 30});
    stage.world.clock.time = 110;
    stage.place_ball({10, 0});
    stage.command(passer, "(kick 30 90)");
    stage.step();
    stage.place_ball({18, 0});
    stage.take_calls();
  }

  Stage stage;
  Player& passer;
  Player& runner;
};

TEST_F(OffsideTiming, CallsOffsideForMissedKickNearBall) {
  stage.command(runner, "(kick 100 0)");
  EXPECT_EQ(stage.take_calls(), (Calls{"111 offside_l"}));
  expect_near(stage.world.ball.position, {10, 0}, 1e-3);
  stage.step();
  // Offside line at x = 10; players are moved 9.15 m behind it.
  expect_near(runner.position, {0.85, 0}, 1e-3);
  EXPECT_EQ(stage.world.clock, (simulator::Clock{111, 1}));
  EXPECT_EQ(1 + stage.step_until_mode_changes(), 31);
  EXPECT_EQ(stage.take_calls(), (Calls{"111 free_kick_r"}));
  EXPECT_EQ(stage.world.clock, (simulator::Clock{112, 0}));
}

TEST_F(OffsideTiming, ClearsOffendersFromBallInLastCycles) {
  stage.command(runner, "(kick 100 0)");
  stage.step(25);
  EXPECT_LT(distance(runner.position, stage.world.ball.position), 9.16);
  stage.step(1);
  EXPECT_NEAR(distance(runner.position, stage.world.ball.position), 9.45, 1e-4);
}

TEST_F(OffsideTiming, IgnoresMissedKickFarFromBall) {
  stage.place_ball({17.4, 0});
  stage.command(runner, "(kick 100 0)");
  EXPECT_EQ(stage.take_calls(), Calls{});
}

TEST_F(RefereeTiming, CallsDoubleTouch) {
  Player& player = stage.add(Side::kLeft, {-20, 0});
  stage.place_ball({-19.4, 0});
  stage.world.kick_off_side = Side::kLeft;
  stage.set_mode(PlayMode::kFreeKickLeft);
  stage.take_calls();
  stage.command(player, "(kick 10 0)");
  EXPECT_EQ(stage.take_calls(), (Calls{"10 play_on"}));

  stage.step();
  stage.command(player, "(dash 1)");
  stage.step();
  stage.place_ball(player.position + Vec2{0.6, 0});
  stage.command(player, "(kick 10 0)");

  EXPECT_EQ(stage.take_calls(), (Calls{"12 free_kick_fault_l"}));
  EXPECT_TRUE(player.has(simulator::state::kFreeKickFault));
  EXPECT_EQ(stage.step_until_mode_changes(), 31);
  EXPECT_EQ(stage.take_calls(), (Calls{"12 free_kick_r"}));
  EXPECT_EQ(stage.world.clock, (simulator::Clock{13, 0}));
}

TEST_F(RefereeTiming, TreatsKicksWithoutDashAsOneKick) {
  Player& player = stage.add(Side::kLeft, {-20, 0});
  stage.place_ball({-19.4, 0});
  stage.set_mode(PlayMode::kFreeKickLeft);
  stage.command(player, "(kick 5 0)");
  stage.step();
  stage.place_ball({-19.4, 0});
  stage.command(player, "(kick 5 0)");
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
}

}  // namespace
}  // namespace cls::tests
