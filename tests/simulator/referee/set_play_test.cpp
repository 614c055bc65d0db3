// Ball over the lines, set plays and distances (docs/spec/simulation-model.md 9.2 to 9.9, 9.12).
#include <gtest/gtest.h>

#include <cmath>

#include "simulator/referee/referee.h"
#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Player;
using BallStuck = OnStage;
using CatchFault = OnStage;
using DropBall = OnStage;
using GoalKick = OnStage;
using SetPlay = OnStage;

// A ball that left the pitch after a left player had kicked it from `from`.
class OverTheLine : public ::testing::Test {
 protected:
  void kick_and_leave(Side side, Vec2 from, Vec2 velocity) {
    Player& player = stage.add(side, {0, 10});
    stage.place_ball({0, 10.5});
    stage.command(player, "(kick 1 0)");
    stage.step();
    stage.place_ball(from, velocity);
    stage.world.referee.touch.previous_ball = from;
    stage.take_calls();
    stage.step();
  }

  Stage stage;
};

TEST_F(OverTheLine, AwardsKickInToOpponentOverTouchLine) {
  kick_and_leave(Side::kLeft, {10, 33.9}, {0.5, 1});
  EXPECT_EQ(stage.take_calls(), Calls{"12 kick_in_r"});
  expect_near(stage.world.ball.position, {10.5, 34});
  EXPECT_EQ(stage.world.kick_off_side, Side::kRight);
}

TEST_F(OverTheLine, AwardsGoalKickOverOpponentGoalLine) {
  kick_and_leave(Side::kLeft, {52, 20}, {1, 0});
  EXPECT_EQ(stage.take_calls(), Calls{"12 goal_kick_r"});
  expect_near(stage.world.ball.position, {47, 9.16});
}

TEST_F(OverTheLine, AwardsCornerKickOverOwnGoalLine) {
  kick_and_leave(Side::kRight, {52, -20}, {1, 0});
  EXPECT_EQ(stage.take_calls(), Calls{"12 corner_kick_l"});
  expect_near(stage.world.ball.position, {51.5, -33});
}

TEST_F(OverTheLine, DropsBallWithoutLastToucher) {
  stage.place_ball({40, 33.9}, {0, 1});
  stage.world.referee.touch.toucher = simulator::kNoPlayer;
  stage.step();
  EXPECT_EQ(stage.take_calls(), (Calls{"11 drop_ball", "11 play_on"}));
  expect_near(stage.world.ball.position, {40, 34});
}

TEST_F(OverTheLine, KeepsPlayingWithBallOnLine) {
  kick_and_leave(Side::kLeft, {10, 33.0}, {0, 1.08});
  EXPECT_EQ(stage.take_calls(), Calls{});
}

TEST_F(OverTheLine, CountsOwnGoalForOpponent) {
  kick_and_leave(Side::kLeft, {-52, 3}, {-1, 0});
  EXPECT_EQ(stage.take_calls(), Calls{"12 goal_r_1"});
  EXPECT_EQ(stage.world.kick_off_side, Side::kLeft);
}

TEST_F(OverTheLine, CallsNoGoalBesidePost) {
  kick_and_leave(Side::kLeft, {52, 7.3}, {1, 0});
  EXPECT_EQ(stage.take_calls(), Calls{"12 goal_kick_r"});
}

TEST(IndirectFreeKick, ScoresOnlyAfterTouchOfSecondPlayer) {
  for (const bool touched : {false, true}) {
    Stage stage;
    Player& kicker = stage.add(Side::kLeft, {40, 0});
    Player& mate = stage.add(Side::kLeft, {42, 5});
    stage.place_ball({40.5, 0});
    stage.world.kick_off_side = Side::kLeft;
    stage.set_mode(PlayMode::kIndirectFreeKickLeft);
    stage.command(kicker, "(kick 10 0)");
    stage.step();

    if (touched) {
      stage.place_ball(mate.position + Vec2{0.5, 0});
      stage.command(mate, "(kick 10 0)");
      stage.step();
    }

    stage.place_ball({52, 0}, {1, 0});
    stage.world.referee.touch.previous_ball = {52, 0};
    stage.step();
    EXPECT_EQ(stage.world.mode, touched ? PlayMode::kGoalLeft : PlayMode::kGoalKickRight);
  }
}

TEST_F(SetPlay, KeepsOpponentsAtDistance) {
  Player& own = stage.add(Side::kLeft, {1, 0});
  Player& near = stage.add(Side::kRight, {-3, 4});
  Player& far = stage.add(Side::kRight, {20, 0});
  stage.place_ball({0, 0});
  simulator::award_free_kick(stage.world, Side::kLeft, {0, 0}, stage.events);
  expect_near(own.position, {1, 0});
  expect_near(far.position, {20, 0});
  EXPECT_NEAR(near.position.length(), 9.15 + 0.3, 1e-4);
  expect_near(near.position / near.position.length(), {-0.6, 0.8});
  stage.place(near, {0, 5}, {0.1, 0});
  stage.step();
  EXPECT_NEAR(near.position.length(), 9.45, 1e-4);
  expect_near(near.velocity, {0, 0}, 0.0);
}

TEST_F(SetPlay, KeepsClearedPlayersOnFieldNearLines) {
  Player& near = stage.add(Side::kRight, {55, 33});
  simulator::award_corner_kick(stage.world, Side::kLeft, stage.events);
  stage.place_ball({51.5, 33});
  stage.step();
  EXPECT_GE(distance(near.position, stage.world.ball.position), 9.45);
  EXPECT_LE(near.position.x, 57.5 + 1e-9);
  EXPECT_LE(near.position.y, 39.0 + 1e-9);
}

TEST_F(SetPlay, MovesFreeKickInOpponentPenaltyAreaToItsCorner) {
  simulator::award_free_kick(stage.world, Side::kLeft, {50, -3}, stage.events);
  expect_near(stage.world.ball.position, {36, -20.16});
}

TEST_F(SetPlay, ResumesAfterKickOfEitherTeam) {
  Player& other = stage.add(Side::kRight, {10, 10});
  stage.set_mode(PlayMode::kFreeKickLeft);
  stage.place_ball(other.position + Vec2{0.6, 0});
  stage.command(other, "(kick 10 0)");
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
}

TEST_F(SetPlay, ResumesWhenBallMoves) {
  stage.set_mode(PlayMode::kKickInLeft);
  stage.place_ball({0, 0}, {0.1, 0});
  stage.step();
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
}

TEST_F(GoalKick, LastsUntilBallLeavesPenaltyArea) {
  Player& goalie = stage.add(Side::kLeft, {-47.5, 9.16}, true);
  Player& opponent = stage.add(Side::kRight, {-40, 0});
  stage.place_ball({-55, 3});
  simulator::award_goal_kick(stage.world, Side::kLeft, stage.events);
  expect_near(stage.world.ball.position, {-47, 9.16});
  stage.step();

  // Moved out through the front of the area, which is enlarged by the player size.
  expect_near(opponent.position, {-35.7, 0});
  stage.command(goalie, "(kick 100 0)");
  EXPECT_EQ(stage.world.mode, PlayMode::kGoalKickLeft);
  int steps = 0;
  while (stage.world.mode == PlayMode::kGoalKickLeft && steps < 50) {
    EXPECT_LE(stage.world.ball.position.x, -36.0 + 0.085 + 1e-9);
    stage.step();
    ++steps;
  }

  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
  EXPECT_GT(stage.world.ball.position.x, -36.0);
}

TEST_F(GoalKick, IsRepeatedWhenOpponentTakesIt) {
  Player& opponent = stage.add(Side::kRight, {-40, 0});
  simulator::award_goal_kick(stage.world, Side::kLeft, stage.events);
  stage.place(opponent, stage.world.ball.position + Vec2{0.6, 0});
  stage.take_calls();
  stage.command(opponent, "(kick 50 0)");
  EXPECT_EQ(stage.take_calls(), Calls{"10 goal_kick_l"});
  expect_near(stage.world.ball.acceleration, {0, 0}, 0.0);
}

// A goalie that repeatedly fails to kick the ball out of its area.
class ProperGoalKicks : public ::testing::Test {
 protected:
  // Awards the goal kick to the left and lets the goalie kick so weakly that the ball stays in.
  explicit ProperGoalKicks(bool free_kick_faults = true)
      : stage([=](auto& server) {
          server.proper_goal_kicks = true;
          server.free_kick_faults = free_kick_faults;
        }) {
    simulator::award_goal_kick(stage.world, Side::kLeft, stage.events);
    kick_weakly(stage.add(Side::kLeft, {0, 0}, true));
  }

  void kick_weakly(Player& kicker) {
    stage.place(kicker, stage.world.ball.position - Vec2{0.5, 0});
    stage.take_calls();
    stage.command(kicker, "(kick 5 90)");
    stage.step();
  }

  Stage stage;
};

class ProperGoalKicksWithoutFaults : public ProperGoalKicks {
 protected:
  ProperGoalKicksWithoutFaults() : ProperGoalKicks(false) {}
};

TEST_F(ProperGoalKicks, AreRepeatedWhenBallStopsInAreaUntilFreeKick) {
  Player& goalie = stage.world.player(Side::kLeft, 1);
  for (int repetition = 1; repetition < 3; ++repetition) {
    while (stage.world.ball.velocity.length() >= 0.01 * 0.94) stage.step();
    EXPECT_EQ(stage.take_calls().size(), 1u);
    EXPECT_EQ(stage.world.mode, PlayMode::kGoalKickLeft);
    kick_weakly(goalie);
  }
  stage.step_until_mode_changes();
  EXPECT_EQ(stage.world.mode, PlayMode::kFreeKickRight);
}

TEST_F(ProperGoalKicks, AreRepeatedWhenTeammateKicksInArea) {
  kick_weakly(stage.add(Side::kLeft, {0, 0}));
  EXPECT_EQ(stage.take_calls().front().substr(3), "goal_kick_l");
  EXPECT_EQ(stage.world.mode, PlayMode::kGoalKickLeft);
}

TEST_F(ProperGoalKicks, CallFaultForSecondTouch) {
  Player& goalie = stage.world.player(Side::kLeft, 1);
  stage.command(goalie, "(dash 10)");
  stage.step();
  kick_weakly(goalie);
  EXPECT_EQ(stage.world.mode, PlayMode::kFreeKickFaultLeft);
}

TEST_F(ProperGoalKicksWithoutFaults, AreRepeatedAfterSecondTouch) {
  Player& goalie = stage.world.player(Side::kLeft, 1);
  stage.command(goalie, "(dash 10)");
  stage.step();
  kick_weakly(goalie);
  EXPECT_EQ(stage.take_calls().front().substr(3), "goal_kick_l");
  EXPECT_EQ(stage.world.mode, PlayMode::kGoalKickLeft);
}

TEST_F(BallStuck, DropsBallAfterHundredCycles) {
  stage.place_ball({20, 5});
  stage.step();
  EXPECT_EQ(stage.step_until_mode_changes(99), 99);
  stage.take_calls();
  stage.place_ball({21, 6});
  stage.step();
  EXPECT_EQ(stage.take_calls(), (Calls{"111 drop_ball", "111 play_on"}));
}

TEST_F(DropBall, ClearsBothTeamsAndMovesBallOutOfPenaltyArea) {
  Player& left = stage.add(Side::kLeft, {-37, 20.5});
  Player& right = stage.add(Side::kRight, {-33, 22});
  stage.place_ball({-45, 10});
  simulator::drop_ball(stage.world, stage.events);
  expect_near(stage.world.ball.position, {-36, 20.16});
  EXPECT_GE(distance(left.position, stage.world.ball.position), 9.45);
  EXPECT_GE(distance(right.position, stage.world.ball.position), 9.45);
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
}

TEST_F(CatchFault, IsCalledWhenGoalieCarriesBallOut) {
  Player& goalie = stage.add(Side::kLeft, {-40, 0}, true);
  stage.place_ball({-39.5, 0});
  stage.command(goalie, "(catch 0)");
  stage.step();
  EXPECT_EQ(stage.world.ball_catcher, goalie.slot());
  stage.command(goalie, "(move -30 0)");
  stage.take_calls();
  stage.step();
  EXPECT_EQ(stage.take_calls(), Calls{"12 catch_fault_l"});
  EXPECT_EQ(stage.world.ball_catcher, simulator::kNoPlayer);
}

}  // namespace
}  // namespace cls::tests
