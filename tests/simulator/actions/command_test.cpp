// Commands apart from motion: exclusivity, limits, counters, replies.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Player;
namespace state = simulator::state;

class Command : public ::testing::Test {
 protected:
  Command() : player(stage.add(Side::kLeft, {0, 10})) { stage.place_ball({-30, -30}); }

  Stage stage;
  Player& player;
};

TEST_F(Command, ExecutesOnlyFirstBodyCommandOfCycle) {
  stage.command(player, "(turn 30)(dash 100)(turn 60)(kick 100 0)(tackle 0)(catch 0)");
  EXPECT_EQ(player.counters.turn, 1);
  stage.step();
  EXPECT_NEAR(body_degrees(player), 30.0, 1e-9);
  EXPECT_EQ(player.counters.dash, 0);
  EXPECT_EQ(player.counters.tackle, 0);
  EXPECT_EQ(player.state, state::kStand);
  stage.command(player, "(turn 30)");
  stage.step();
  EXPECT_NEAR(body_degrees(player), 60.0, 1e-9);
}

TEST_F(Command, ClampsAndNormalizesTurns) {
  stage.command(player, "(turn 1000)");
  stage.step();
  EXPECT_NEAR(std::abs(body_degrees(player)), 180.0, 1e-9);
  stage.command(player, "(turn 90)");
  stage.step();
  EXPECT_NEAR(std::abs(body_degrees(player)), 90.0, 1e-9);
}

TEST_F(Command, AllowsLegDashWhileBlockedByTackle) {
  stage.place_ball({1, 10});
  stage.world.overrides.emplace().tackle.recorded[0] = false;
  stage.command(player, "(tackle 0)");
  stage.step();
  EXPECT_EQ(player.tackle_cycles, 9);
  stage.command(player, "(dash 100)");
  stage.step();
  EXPECT_EQ(player.counters.dash, 0);
  stage.command(player, "(dash (l 100 0) (r 100 0))");
  stage.step();
  EXPECT_EQ(player.counters.dash, 1);
  EXPECT_GT(player.position.x, 0.0);
}

TEST_F(Command, TackleBlocksNineMoreCycles) {
  stage.command(player, "(tackle 0)");
  for (int cycle = 1; cycle < 10; ++cycle) {
    stage.step();
    stage.command(player, "(turn 10)");
    EXPECT_EQ(player.counters.turn, 0) << cycle;
  }
  stage.step();
  stage.command(player, "(turn 10)");
  EXPECT_EQ(player.counters.turn, 1);
}

TEST_F(Command, TackleBitLastsWhileBlocked) {
  stage.place_ball({1, 10});
  stage.world.overrides.emplace().tackle.recorded[0] = true;
  stage.command(player, "(tackle 0)");
  int frames = 0;
  for (int i = 0; i < 20; ++i) {
    simulator::step(stage.world, stage.events);
    if (player.has(state::kTackle)) ++frames;
    finish_step(stage.world, stage.events);
  }
  EXPECT_EQ(frames, 10);
}

TEST_F(Command, TackleOfOldClientsUsesPower) {
  player.client_version = 11;
  stage.place_ball({1, 10});
  stage.world.overrides.emplace().tackle.recorded[0] = true;
  stage.command(player, "(tackle 50)");
  // Straight ahead, independent of the ball position; the noise is that of half power.
  EXPECT_NEAR(stage.world.ball.acceleration.x, 50 * 0.027, 1e-9);
  EXPECT_NEAR(stage.world.ball.acceleration.y, 0.0, 1e-9);
}

TEST_F(Command, TurnsNeckOncePerCycleWithinLimits) {
  stage.command(player, "(turn_neck 60)(turn_neck 60)(turn 10)");
  stage.step();
  EXPECT_NEAR(soccer::math::to_degrees(player.neck), 60.0, 1e-9);
  stage.command(player, "(turn_neck 60)");
  stage.step();
  EXPECT_NEAR(soccer::math::to_degrees(player.neck), 90.0, 1e-9);
  EXPECT_EQ(player.counters.turn_neck, 2);
  EXPECT_EQ(player.counters.turn, 1);
}

TEST_F(Command, KeepsFocusInViewCone) {
  player.view.synchronous = true;
  stage.command(player, "(change_focus 50 70)");
  EXPECT_DOUBLE_EQ(player.view.focus_distance, 40.0);
  EXPECT_NEAR(soccer::math::to_degrees(player.view.focus_direction), 60.0, 1e-9);
  stage.command(player, "(change_view narrow)");
  EXPECT_NEAR(soccer::math::to_degrees(player.view.focus_direction), 30.0, 1e-9);
  expect_near(focus_point(player),
              player.position + Vec2{40 * std::cos(0.5235987755982988), 40 * 0.5});
  EXPECT_EQ(player.counters.change_focus, 1);
  EXPECT_EQ(player.counters.change_view, 1);
}

TEST_F(Command, ChangeViewWithQualityKeepsFocusOutsideViewCone) {
  player.view.synchronous = true;
  stage.command(player, "(change_focus 5 50)(change_view narrow high)");
  EXPECT_NEAR(soccer::math::to_degrees(player.view.focus_direction), 50.0, 1e-9);
}

TEST_F(Command, RejectsLowQualityInSynchronousMode) {
  player.view.synchronous = false;
  stage.command(player, "(change_view wide low)");
  EXPECT_EQ(player.view.quality, soccer::ViewQuality::kLow);
  stage.command(player, "(synch_see)");
  EXPECT_TRUE(std::holds_alternative<soccer::OkSynchSee>(*stage.reply));
  EXPECT_EQ(player.view.quality, soccer::ViewQuality::kHigh);
  stage.command(player, "(change_view narrow low)");
  EXPECT_EQ(player.view.width, soccer::ViewWidth::kWide);
  EXPECT_EQ(player.counters.change_view, 1);
}

TEST_F(Command, MovesArmOnlyAfterPointToBan) {
  stage.command(player, "(pointto 10 90)");
  expect_near(player.arm.target, {0, 20});
  EXPECT_TRUE(is_pointing(stage.world, player));

  stage.step(4);
  stage.command(player, "(pointto 5 0)(pointto off)");
  EXPECT_EQ(player.counters.pointto, 1);

  stage.step();
  stage.command(player, "(pointto off)");
  EXPECT_EQ(player.counters.pointto, 2);
  EXPECT_FALSE(is_pointing(stage.world, player));
  stage.command(player, "(pointto 5 0)");
  stage.step(19);
  EXPECT_TRUE(is_pointing(stage.world, player));
  stage.step();
  EXPECT_FALSE(is_pointing(stage.world, player));
}

TEST_F(Command, LimitsDistanceToWhichArmPoints) {
  for (const char* command :
       {"(pointto 3e38 30)", "(pointto -1e12 -20)", "(pointto 1e308 1e308)"}) {
    stage.command(player, command);
    EXPECT_LT((player.arm.target - player.position).length(), 1.1e6) << command;
    stage.step(20);
  }
  EXPECT_EQ(player.counters.pointto, 3);
}

TEST_F(Command, AttendsOnlyToConnectedPlayers) {
  stage.add(Side::kLeft, {-10, 0});
  stage.world.team(Side::kLeft).name = "Blue";
  stage.command(player, "(attentionto our 2)");
  EXPECT_EQ(player.attention, 1);
  // Itself, a player that is not connected, a team that is not connected, an unknown name.
  stage.command(player, "(attentionto our 1)(attentionto our 3)(attentionto opp 1)");
  stage.command(player, "(attentionto Red 1)");
  EXPECT_EQ(player.attention, 1);
  EXPECT_EQ(player.counters.attentionto, 1);

  stage.command(player, "(attentionto off)");
  EXPECT_EQ(player.attention, simulator::kNoPlayer);
  stage.command(player, "(attentionto Blue 2)");
  EXPECT_EQ(player.attention, 1);
  EXPECT_EQ(player.counters.attentionto, 3);
}

TEST_F(Command, IgnoresSayMessagesThatAreTooLong) {
  stage.command(player, "(say \"0123456789\")(say \"01234567890\")");
  EXPECT_EQ(player.counters.say, 1);
  ASSERT_EQ(stage.events.size(), 1U);
  const auto& said = std::get<simulator::PlayerSaid>(stage.events[0].what);
  EXPECT_EQ(said.text, "0123456789");
  EXPECT_EQ(said.speaker, player.slot());
}

TEST_F(Command, EarSetsModesPerSide) {
  stage.command(player, "(ear (off opp))");
  EXPECT_TRUE(player.ears.complete[0]);
  EXPECT_FALSE(player.ears.complete[1]);
  stage.command(player, "(ear (on partial))");
  EXPECT_TRUE(player.ears.partial[0] && player.ears.partial[1]);
  EXPECT_FALSE(player.ears.complete[1]);
  stage.command(player, "(ear (on Nowhere))");
  EXPECT_EQ(std::get<soccer::ErrorReply>(*stage.reply).text, "no team with name Nowhere");
}

TEST_F(Command, ScoreReplyStartsWithOwnScore) {
  Player& other = stage.add(Side::kRight, {10, 10});
  stage.world.team(Side::kLeft).score = 3;
  stage.command(other, "(score)");
  const auto score = std::get<soccer::ScoreReply>(*stage.reply);
  EXPECT_EQ(score.time, 10);
  EXPECT_EQ(score.our, 0);
  EXPECT_EQ(score.opponent, 3);
}

TEST_F(Command, IgnoresDisabledPlayers) {
  leave(stage.world, player.slot());
  stage.command(player, "(turn 30)(say \"x\")");
  EXPECT_EQ(player.counters.turn, 0);
  EXPECT_TRUE(stage.events.empty());
}

TEST_F(Command, WarnsOfMoveIntoOpponentHalfAndUndoesIt) {
  stage.set_mode(PlayMode::kBeforeKickOff);
  stage.command(player, "(move -0.2 20)");
  EXPECT_EQ(std::get<soccer::WarningReply>(*stage.reply).text, "moving_to_opponent_field");
  expect_near(player.position, {-0.2, 20});
  player.command_done = false;
  stage.command(player, "(move 20 20)");
  stage.step();
  EXPECT_LE(player.position.x, 0.0);
}

TEST_F(Command, MirrorsMovesOfRightTeam) {
  Player& other = stage.add(Side::kRight, {10, 10});
  stage.set_mode(PlayMode::kBeforeKickOff);
  stage.command(other, "(move -20 5)");
  EXPECT_FALSE(stage.reply.has_value());
  expect_near(other.position, {20, -5});
}

TEST_F(Command, IgnoresMoveDuringPlayOn) {
  stage.command(player, "(move -20 5)(turn 30)");
  expect_near(player.position, {0, 10});
  EXPECT_EQ(player.counters.move, 0);
  EXPECT_EQ(player.counters.turn, 1);
}

TEST_F(Command, ReportsKickFaultWithoutBall) {
  stage.command(player, "(kick 100 0)");
  EXPECT_EQ(player.state, state::kStand | state::kKick | state::kKickFault);
  EXPECT_EQ(player.counters.kick, 0);
  stage.step();
  EXPECT_EQ(player.state, state::kStand);
}

TEST_F(Command, BansCatchForFiveCycles) {
  Player& goalie = stage.add(Side::kLeft, {-46, 0}, true);
  stage.command(goalie, "(catch 0)");
  EXPECT_EQ(goalie.catch_ban, 5);
  EXPECT_EQ(goalie.counters.catches, 0);
  for (int i = 0; i < 4; ++i) {
    stage.step();
    EXPECT_GT(goalie.catch_ban, 0);
  }
  stage.step();
  EXPECT_EQ(goalie.catch_ban, 0);
}

TEST_F(Command, PunchesBallAfterFailedCatch) {
  Player& goalie = stage.add(Side::kLeft, {-46, 0}, true);
  stage.place_ball({-45, 0}, {-1, 0.5});
  stage.world.overrides.emplace().catch_ball.recorded[static_cast<std::size_t>(goalie.slot())] =
      false;
  stage.command(goalie, "(catch 0)");
  EXPECT_TRUE(goalie.has(state::kCatchFault));
  expect_near(stage.world.ball.acceleration, {2, 0});
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
  EXPECT_EQ(goalie.counters.catches, 1);
}

}  // namespace
}  // namespace cls::tests
