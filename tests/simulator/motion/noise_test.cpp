// Distributions of noise (docs/spec/simulation-model.md 3.1, 4.2, 4.4, 14.5).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Player;
using soccer::math::kPi;

constexpr int kSamples = 20000;

/// Mean length, maximum length and share of short noise vectors, in units of the limit.
struct Radii {
  double sum = 0.0;
  double largest = 0.0;
  int short_ones = 0;
  Vec2 mean;
  int count = 0;

  void add(Vec2 noise, double limit) {
    const double radius = noise.length() / limit;
    sum += radius;
    largest = std::max(largest, radius);
    if (radius < 0.25) ++short_ones;
    mean += noise / limit;
    ++count;
  }
};

// Uniform in radius: a quarter of the samples is within a quarter of the radius. In a uniform disc
// it would be a sixteenth.
void expect_uniform_in_radius(const Radii& radii) {
  ASSERT_EQ(radii.count, kSamples);
  EXPECT_NEAR(radii.sum / kSamples, 0.5, 0.01);
  EXPECT_NEAR(radii.short_ones / double(kSamples), 0.25, 0.015);
  EXPECT_LE(radii.largest, 1.0 + 1e-12);
  EXPECT_GT(radii.largest, 0.999);
  EXPECT_NEAR(radii.mean.x / kSamples, 0.0, 0.015);
  EXPECT_NEAR(radii.mean.y / kSamples, 0.0, 0.015);
}

// Default noise, and no half time, which would end the sampling.
soccer::ServerParams endless() {
  soccer::ServerParams server;
  server.half_time = -1;
  return server;
}

class Noise : public testing::Test {
 protected:
  /// The next sample: play goes on, whatever has happened.
  void resume() {
    stage.set_mode(PlayMode::kPlayOn);
    stage.events.clear();
  }

  Stage stage{endless()};
  Player& player = stage.add(Side::kLeft, {0, 10});
};

TEST_F(Noise, OfBallGrowsWithSpeed) {
  stage.place(player, {-30, 10});
  for (const double speed : {0.5, 2.5}) {
    Radii radii;
    for (int i = 0; i < kSamples; ++i) {
      stage.place_ball({0, 0}, {speed, 0});
      stage.step();
      radii.add(stage.world.ball.position - Vec2{speed, 0}, 0.05 * speed);
      resume();
    }
    expect_uniform_in_radius(radii);
  }
}

TEST_F(Noise, OfPlayersIsRelativeToSpeed) {
  stage.place_ball({-30, 0});
  Radii radii;
  for (int i = 0; i < kSamples; ++i) {
    stage.place(player, {0, 10}, {0.3, 0.4});
    stage.step();
    radii.add(player.position - Vec2{0.3, 10.4}, 0.1 * 0.5);
    stage.place_ball({-30, 0});
    resume();
  }
  expect_uniform_in_radius(radii);
}

TEST_F(Noise, OfTurnIsUniformWithinTenthOfMoment) {
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    player.command_done = false;
    stage.command(player, "(turn 90)");
    const double error = player.pending_body / (kPi / 2.0) - 1.0;
    EXPECT_LE(std::abs(error), 0.1 + 1e-12);
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kSamples, 0.0, 0.002);
  EXPECT_NEAR(squares / kSamples, 0.1 * 0.1 / 3.0, 0.0001);
}

// Variance of each component is R^2 / 6 where radii are uniform up to R.
void expect_kick_noise(Vec2 ball, Vec2 ball_velocity, double power, double rate) {
  Stage stage{endless()};
  Player& player = stage.add(Side::kLeft, {0, 10});
  const double limit = 0.1 * power / 100.0 * rate;
  Vec2 mean;
  std::vector<Vec2> pushes;

  for (int i = 0; i < kSamples; ++i) {
    player.command_done = false;
    stage.place_ball(player.position + ball, ball_velocity);
    stage.command(player, "(kick " + std::to_string(power) + " 0)");
    pushes.push_back(stage.world.ball.acceleration);
    mean += stage.world.ball.acceleration / kSamples;
    stage.events.clear();
  }

  Vec2 variance;
  for (const Vec2 push : pushes) {
    const Vec2 off = push - mean;
    variance += Vec2{off.x * off.x, off.y * off.y} / kSamples;
    EXPECT_LE(off.length(), limit * 1.05);
  }

  EXPECT_NEAR(variance.x / (limit * limit / 6.0), 1.0, 0.05);
  EXPECT_NEAR(variance.y / (limit * limit / 6.0), 1.0, 0.05);
}

TEST(KickNoise, GrowsWithPowerDistanceAngleAndBallSpeed) {
  // Closest position in front, ball at rest: 0.5 by position and 0.5 by speed.
  expect_kick_noise({0.385, 0}, {}, 100, 1.0);
  expect_kick_noise({0.385, 0}, {}, 50, 1.0);
  // At the far edge and behind: 0.5 more.
  expect_kick_noise({-1.085 + 1e-6, 0}, {}, 100, 1.5);
  // At maximum speed after decay: 0.5 more.
  expect_kick_noise({0.385, 0}, {0, 3.0 * 0.94}, 100, 1.5);
}

TEST_F(Noise, IsZeroAtRest) {
  stage.place_ball({-30, 0});
  stage.step(50);
  expect_near(player.position, {0, 10}, 0.0);
  expect_near(stage.world.ball.position, {-30, 0}, 0.0);
}

TEST_F(Noise, TackleSucceedsWithComputedProbability) {
  int successes = 0;
  for (int i = 0; i < kSamples; ++i) {
    player.command_done = false;
    player.state = simulator::state::kStand;
    stage.place_ball({1.6, 10.5});
    stage.command(player, "(tackle 0)");
    if (!player.has(simulator::state::kTackleFault)) ++successes;
    stage.events.clear();
  }
  const double failure = std::pow(1.6 / 2.0, 6) + std::pow(0.5 / 1.25, 6);
  EXPECT_NEAR(successes / double(kSamples), 1.0 - failure, 0.01);
}

TEST(Wind, AcceleratesOnlyWithRandomPart) {
  soccer::ServerParams server = noise_free_params();
  server.wind_force = 10.0;

  for (const double rand : {0.0, 0.3}) {
    server.wind_rand = rand;
    Stage stage(server);
    stage.place_ball({0, 0}, {0, 2.0});
    stage.step();
    if (rand == 0.0) {
      expect_near(stage.world.ball.position, {0, 2.0}, 0.0);
    } else {
      // Speed 2 times (10 and something) over weight times 10000.
      EXPECT_NEAR(stage.world.ball.position.x, 2.0 * 10.0 / (0.2 * 10000), 2.0 * 0.3 / 2000);
      EXPECT_NE(stage.world.ball.position.x, 0.0);
    }
  }
}

}  // namespace
}  // namespace cls::tests
