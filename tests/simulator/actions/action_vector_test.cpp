// Results of rcssserver 19.0.0 for single commands without noise
// (docs/spec/simulation-model.md 14.2).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Player;
using CollisionVector = OnStage;
using GoalPostVector = OnStage;
using KickVector = OnStage;

// Printed with six significant digits.
constexpr double kPrinted = 5e-6;

class DashVector : public ::testing::Test {
 protected:
  DashVector() : player(stage.add(Side::kLeft, {0, 10})) { stage.place_ball({-30, -30}); }

  void run(const std::string& command) {
    ASSERT_TRUE(stage.command(player, command));
    stage.step();
  }

  Stage stage;
  Player& player;
};

TEST_F(DashVector, AcceleratesFromDashToDash) {
  run("(dash 100)");
  expect_near(player.position, {0.6, 10});
  expect_near(player.velocity, {0.24, 0});

  run("(dash 100)");
  expect_near(player.position, {1.44, 10});
  expect_near(player.velocity, {0.336, 0});
  run("(dash 100 90)");
  expect_near(player.position, {1.776, 10.24});
  expect_near(player.velocity, {0.1344, 0.096});
  run("(turn 60)");
  expect_near(player.position, {1.9104, 10.336});
  expect_near(player.velocity, {0.05376, 0.0384});
  EXPECT_NEAR(body_degrees(player), 60.0 / (1.0 + 5.0 * std::hypot(0.1344, 0.096)), 1e-9);
  EXPECT_EQ(std::rint(body_degrees(player)), 33);
}

TEST_F(DashVector, IsWeakerBackwards) {
  run("(dash 100 180)");
  expect_near(player.position, {-0.42, 10});
  expect_near(player.velocity, {-0.168, 0});
}

TEST_F(DashVector, QuantizesDirections) {
  run("(dash 100 -45.4)");
  expect_near(player.position, {0.296985, 9.703015}, kPrinted);
  expect_near(player.velocity, {0.118794, -0.118794}, kPrinted);
}

TEST_F(DashVector, ComputesDiagonalBackwardDash) {
  run("(dash 100 135)");
  expect_near(player.position, {-0.233345, 10.233345}, kPrinted);
}

TEST_F(DashVector, ClampsNegativePowerToZero) {
  run("(dash -50)");
  expect_near(player.position, {0, 10}, 0.0);
  EXPECT_EQ(player.counters.dash, 1);
}

TEST_F(DashVector, LeftLegAloneRotatesBody) {
  run("(dash (l 100 0) (r 0 0))");
  expect_near(player.position, {0.3, 10});
  expect_near(player.velocity, {0.12, 0});
  EXPECT_EQ(std::rint(body_degrees(player)), 57);
  EXPECT_NEAR(player.body, 1.0, 1e-9);
}

TEST_F(DashVector, RightLegAloneDoesNotRotateBody) {
  run("(dash (r 100 0))");
  expect_near(player.position, {0.3, 10});
  expect_near(player.velocity, {0.12, 0});
  EXPECT_EQ(body_degrees(player), 0.0);
}

TEST_F(DashVector, AllowsDifferentPowerAndDirectionPerLeg) {
  run("(dash (l 100 30) (r 60 -30))");
  expect_near(player.position, {0.332554, 10.048}, kPrinted);
  expect_near(player.velocity, {0.133022, 0.0192}, kPrinted);
  EXPECT_EQ(std::rint(body_degrees(player)), 16);
}

TEST_F(DashVector, ExhaustedDashRotatesAndIsSlightlyTooStrong) {
  player.stamina.value = 0.0;
  player.stamina.effort = 0.99;
  run("(dash 100)");
  expect_near(player.position, {0.3465, 10});
  EXPECT_EQ(std::rint(body_degrees(player)), -9);
}

TEST_F(KickVector, KicksBallStraightAhead) {
  Player& player = stage.add(Side::kLeft, {0, 10});
  stage.place_ball({0.6, 10});
  stage.command(player, "(kick 100 0)");
  stage.step();
  expect_near(stage.world.ball.position, {3.09268, 10}, kPrinted);
  expect_near(stage.world.ball.velocity, {2.34312, 0}, kPrinted);
  EXPECT_EQ(player.counters.kick, 1);
}

TEST_F(KickVector, KicksBallAtTheSide) {
  Player& player = stage.add(Side::kLeft, {0, 10});
  stage.place_ball({0, 10.8});
  stage.command(player, "(kick 50 45)");
  stage.step();
  expect_near(stage.world.ball.position, {0.693785, 11.493785}, kPrinted);
  expect_near(stage.world.ball.velocity, {0.652158, 0.652158}, kPrinted);
}

TEST(TackleVector, PushesBallSideways) {
  Stage stage([](auto& server) { server.tackle_rand_factor = 0.0; });
  Player& player = stage.add(Side::kLeft, {0, 10});
  stage.place_ball({1.0, 10.2});
  stage.world.overrides.emplace().tackle.recorded[0] = true;
  stage.command(player, "(tackle 90)");
  stage.step();
  expect_near(stage.world.ball.position, {1.0, 11.5076}, 5e-5);
  expect_near(stage.world.ball.velocity, {0, 1.22913}, kPrinted);
  EXPECT_EQ(player.tackle_cycles, 9);
}

TEST_F(CollisionVector, MovesBallAndPlayerApartEqually) {
  Player& player = stage.add(Side::kLeft, {0, 10});
  stage.place_ball({1, 10}, {-0.8, 0});
  stage.step();
  expect_near(stage.world.ball.position, {0.2925, 10});
  expect_near(stage.world.ball.velocity, {0.0752, 0});
  expect_near(player.position, {-0.0925, 10});
}

TEST_F(CollisionVector, SeparatesTwoPlayers) {
  stage.place_ball({-30, -30});
  Player& a = stage.place(stage.add(Side::kLeft, {0, 10}), {0, 10}, {0.4, 0});
  Player& b = stage.place(stage.add(Side::kLeft, {1, 10}), {1, 10}, {-0.2, 0.1});
  stage.step();
  expect_near(a.position, {0.308957, 9.97724}, 5e-5);
  expect_near(a.velocity, {-0.016, 0});
  expect_near(b.position, {0.891043, 10.1228}, 5e-5);
  expect_near(b.velocity, {0.008, -0.004});
}

TEST_F(CollisionVector, KeepsBallInPlaceDuringSetPlay) {
  Player& player = stage.add(Side::kLeft, {-5, -10});
  stage.place_ball({0, -10});
  stage.world.kick_off_side = Side::kLeft;
  stage.set_mode(PlayMode::kFreeKickLeft);
  stage.place(player, {-0.5, -10}, {0.3, 0});
  stage.step();
  expect_near(stage.world.ball.position, {0, -10}, 0.0);
  expect_near(stage.world.ball.velocity, {0, 0}, 0.0);
  expect_near(player.position, {-0.385, -10});
  expect_near(player.velocity, {-0.012, 0});
  EXPECT_EQ(stage.world.mode, PlayMode::kFreeKickLeft);
}

class CatchVector : public ::testing::Test {
 protected:
  void put(Vec2 goalie_place, Vec2 ball) {
    goalie = &stage.add(Side::kLeft, goalie_place, true);
    stage.place_ball(ball);
  }

  Stage stage;
  Player* goalie = nullptr;
};

TEST_F(CatchVector, GoalieCatchesBallAndMovesTwice) {
  put({-46, 0}, {-45, 0});
  stage.command(*goalie, "(catch 0)");
  EXPECT_EQ(stage.take_calls(), (Calls{"10 goalie_catch_ball_l", "10 free_kick_l"}));

  stage.step();
  expect_near(goalie->position, {-45.385, 0});
  expect_near(stage.world.ball.position, {-45, 0});

  for (const Vec2 place : {Vec2{-44, 5}, Vec2{-40, 3}}) {
    stage.command(*goalie,
                  "(move " + std::to_string(place.x) + ' ' + std::to_string(place.y) + ")");
    EXPECT_FALSE(stage.reply.has_value());
    stage.step();
    expect_near(goalie->position, place);
    expect_near(stage.world.ball.position, place + Vec2{0.385, 0});
  }
  stage.command(*goalie, "(move -41 3)");
  ASSERT_TRUE(stage.reply.has_value());
  EXPECT_EQ(std::get<soccer::ErrorReply>(*stage.reply).text, "too_many_moves");

  stage.step();
  expect_near(goalie->position, {-40, 3});
  EXPECT_EQ(goalie->counters.move, 3);
}

TEST_F(CatchVector, CallsCatchFaultOutsidePenaltyArea) {
  put({-31, 0}, {-30, 0});
  stage.command(*goalie, "(catch 0)");
  EXPECT_EQ(stage.take_calls(), (Calls{"10 goalie_catch_ball_l", "10 catch_fault_l"}));
  stage.step();
  expect_near(stage.world.ball.position, {-30, 0});
}

TEST_F(CatchVector, BackPassLeadsToIndirectFreeKick) {
  put({-46, 0}, {-44, 0});
  Player& mate = stage.add(Side::kLeft, {-43.5, 0});
  stage.command(mate, "(kick 1 180)");
  stage.step();
  stage.place_ball({-45, 0});
  stage.take_calls();
  stage.command(*goalie, "(catch 0)");
  EXPECT_EQ(stage.take_calls(), (Calls{"11 goalie_catch_ball_l", "11 back_pass_l"}));
  expect_near(stage.world.ball.position, {-45, 0});
  EXPECT_EQ(stage.step_until_mode_changes(), 31);
  EXPECT_EQ(stage.world.mode, PlayMode::kIndirectFreeKickRight);
  EXPECT_EQ(stage.world.clock.time, 12);
}

TEST_F(GoalPostVector, ReflectsCentralAndGrazingHits) {
  stage.place_ball({51, 7.07}, {1.8, 0});
  stage.step();
  expect_near(stage.world.ball.position, {51.79, 7.07});
  expect_near(stage.world.ball.velocity, {-1.692, 0});
  stage.place_ball({51, 7.1}, {1.8, 0});
  stage.step();
  expect_near(stage.world.ball.position, {51.8392, 7.30317}, 5e-5);
  expect_near(stage.world.ball.velocity, {-1.54714, 0.684989}, kPrinted);
}

}  // namespace
}  // namespace cls::tests
