// Accuracy and estimated variance with Gaussian noise of distances, after (gaussian_see).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "player/perception/perception.h"
#include "player/perception/transcript.h"
#include "player/tracking/tracking.h"
#include "soccer/random.h"
#include "tests/player/tracking/synthetic_senses.h"

namespace cls::player {
namespace {

using tests::TrueWorld;

WorldModel gaussian_model() {
  WorldModel world;
  on_init(world, {Side::kLeft, 7, PlayMode::kPlayOn}, tests::kLeftTeam, false);
  on_gaussian_see(world);
  return world;
}

struct Accuracy {
  double error = 0.0;     ///< mean
  double surprise = 0.0;  ///< mean of squared error over estimated variance, per axis
  int n = 0;

  void add(Vec2 estimate, Vec2 truth, double variance_x, double variance_y) {
    const Vec2 off = estimate - truth;
    error += off.length();
    surprise += 0.5 * (off.x * off.x / variance_x + off.y * off.y / variance_y);
    ++n;
  }
  double mean_error() const { return error / n; }
  double mean_surprise() const { return surprise / n; }
};

void expect_calibrated(const Accuracy& accuracy) {
  EXPECT_GT(accuracy.mean_surprise(), 0.7);
  EXPECT_LT(accuracy.mean_surprise(), 1.4);
}

/// Own position from single see messages at random poses, with a focus point at `focus_distance`.
Accuracy single_sees(soccer::ViewWidth width, double focus_distance) {
  soccer::RandomStream random(21, "gaussian looks");
  Accuracy own;
  for (int i = 0; i < 500; ++i) {
    TrueWorld truth;
    truth.gaussian = &random;
    truth.width = width;
    truth.focus_distance = focus_distance;
    truth.self.position = {random.uniform(-52.0, 52.0), random.uniform(-33.5, 33.5)};
    truth.self.body = random.uniform(-180.0, 180.0);

    WorldModel world = gaussian_model();
    for (int cycle = 0; cycle < 2; ++cycle, ++truth.time) {
      on_sense_body(world, tests::sense_of(truth));
      on_see(world, tests::see_of(truth));
    }
    if (world.self.pos_count != 0) continue;

    const Gaussian<3>& pose = world.self_tracker.pose;
    own.add(world.self.position, truth.self.position, pose.at(0, 0), pose.at(1, 1));
  }
  return own;
}

TEST(GaussianSee, LocalizesAgent) {
  for (const double focus : {0.0, 20.0}) {
    for (const auto& [width, limit] : {std::pair{soccer::ViewWidth::kWide, 0.025},
                                       {soccer::ViewWidth::kNormal, 0.04},
                                       {soccer::ViewWidth::kNarrow, 0.09}}) {
      const Accuracy own = single_sees(width, focus);
      EXPECT_LT(own.mean_error(), limit);
      expect_calibrated(own);
      EXPECT_GT(own.n, 470);
    }
  }
}

struct BallAccuracy {
  Accuracy position;
  Accuracy velocity;
};

/// The ball after rolling for `cycles` at 10 to 20 m, observed in each of them.
BallAccuracy follow_ball(bool gaussian, bool focus_on_ball, int cycles) {
  soccer::RandomStream random(22, "gaussian ball");
  BallAccuracy accuracy;
  for (int i = 0; i < 300; ++i) {
    TrueWorld truth;
    truth.gaussian = gaussian ? &random : nullptr;
    truth.width = soccer::ViewWidth::kWide;
    truth.self.position = {-20.0, 3.0};
    truth.ball = {random.uniform(-10.0, 0.0), random.uniform(-8.0, 8.0)};
    truth.ball_velocity =
        soccer::polar_degrees(random.uniform(0.5, 1.5), random.uniform(-180.0, 180.0));
    truth.unum_far = 40.0;

    WorldModel world = gaussian_model();
    world.self.gaussian_see = gaussian;
    for (int cycle = 0; cycle < cycles; ++cycle) {
      if (focus_on_ball) {
        const Vec2 offset = truth.ball - truth.self.position;
        truth.focus_distance = offset.length() + random.uniform(-0.3, 0.3);
        truth.focus_direction = soccer::direction_degrees(offset);
      }
      on_sense_body(world, tests::sense_of(truth));
      on_see(world, tests::see_of(truth));
      if (cycle == cycles - 1) break;
      ++truth.time;
      truth.ball_velocity += soccer::polar_degrees(
          random.uniform(0.0, 0.05 * truth.ball_velocity.length()), random.uniform(-180.0, 180.0));
      truth.ball += truth.ball_velocity;
      truth.ball_velocity *= 0.94;
    }

    const ObjectEstimate& state = world.ball_tracker.state;
    accuracy.position.add(world.ball.position, truth.ball, state.at(0, 0), state.at(1, 1));
    accuracy.velocity.add(world.ball.velocity, truth.ball_velocity, state.at(2, 2), state.at(3, 3));
  }

  return accuracy;
}

void print(const char* what, const BallAccuracy& accuracy) {
  fmt::print("{}: position {:.3f} ({:.2f}), velocity {:.4f} ({:.2f})\n", what,
             accuracy.position.mean_error(), accuracy.position.mean_surprise(),
             accuracy.velocity.mean_error(), accuracy.velocity.mean_surprise());
}

TEST(GaussianSee, TracksBall) {
  for (const int cycles : {1, 2, 6}) {
    for (const bool focus : {false, true}) {
      const BallAccuracy gaussian = follow_ball(true, focus, cycles);
      const BallAccuracy quantized = follow_ball(false, focus, cycles);
      print(fmt::format("{} cycles, focus {}, gaussian ", cycles, focus).c_str(), gaussian);
      print(fmt::format("{} cycles, focus {}, quantized", cycles, focus).c_str(), quantized);
      expect_calibrated(gaussian.position);
      expect_calibrated(gaussian.velocity);
    }
  }
  // The printed distance change has steps of 0.01 m, not of 2 % of the distance.
  EXPECT_LT(follow_ball(true, false, 1).velocity.mean_error(),
            0.5 * follow_ball(false, false, 1).velocity.mean_error());
}

TEST(GaussianSee, BeginsWithReplyOfServer) {
  const auto nothing = [](const WorldModel&) {};
  const std::string before =
      "C>S\t0\t(init Us (version 19))\nS>C\t0\t(init l 7 "
      "before_kick_off)\nC>S\t0\t(gaussian_see)\n";
  EXPECT_FALSE(replay_transcript(before, nothing).world.self.gaussian_see);
  EXPECT_TRUE(
      replay_transcript(before + "S>C\t0\t(ok gaussian_see)\n", nothing).world.self.gaussian_see);
}

}  // namespace
}  // namespace cls::player
