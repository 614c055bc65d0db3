// Success rates of skills with rcssserver's noise.
#include <gtest/gtest.h>

#include "soccer/random.h"
#include "tests/proxy/support/wire_vector.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using protos::PlayerActions;
using soccer::AngleDeg;
using soccer::Vec2;
using tests::KnownPitch;
using tests::Noise;
using tests::set;

/// Random vector with a length between two bounds.
Vec2 around(soccer::RandomStream& random, double nearest, double farthest) {
  const double angle = random.uniform(-180.0, 180.0);
  return soccer::polar_degrees(random.uniform(nearest, farthest), angle);
}

/// Random agent pose with a kickable ball.
KnownPitch kickable_ball(soccer::RandomStream& random, std::uint64_t seed) {
  KnownPitch pitch(Noise::kReal, seed);
  pitch.place_self({}, random.uniform(-180.0, 180.0), around(random, 0.0, 0.3));
  pitch.place_ball(around(random, 0.5, 1.0), around(random, 0.0, 0.6));
  return pitch;
}

TEST(UnderNoise, SmartKickReachesNearlyFullSpeed) {
  constexpr int kTrials = 100;
  constexpr double kSpeed = 2.8;
  soccer::RandomStream random(1, "smart kick");
  int done = 0;
  double error = 0.0;

  for (int trial = 0; trial < kTrials; ++trial) {
    KnownPitch pitch = kickable_ball(random, static_cast<std::uint64_t>(trial));
    const Vec2 target = around(random, 20.0, 30.0);
    Vec2 from;
    for (int kicks = 0; kicks < 4 && pitch.world.self.kickable; ++kicks) {
      from = pitch.world.ball.position;
      pitch.act([&](PlayerActions& reply) {
        auto& kick = *reply.add_actions()->mutable_body_smart_kick();
        set(kick.mutable_target_point(), target);
        kick.set_first_speed(kSpeed);
        kick.set_first_speed_threshold(0.9 * kSpeed);
        kick.set_max_steps(3);
      });
    }
    const Vec2 velocity = pitch.world.ball.velocity / pitch.world.server().ball_decay;
    const double off = (AngleDeg::of(velocity) - AngleDeg::of(target - from)).abs();
    done += velocity.length() > 0.85 * kSpeed && off < 6.0 ? 1 : 0;
    error += off / kTrials;
  }

  EXPECT_GE(done, 97);
  EXPECT_LT(error, 2.0);
}

TEST(UnderNoise, DribbleCoversThirtyMeters) {
  soccer::RandomStream random(2, "dribble");
  const Vec2 target{10.0, 5.0};
  constexpr int kTrials = 50;
  int arrived = 0;
  int cycles = 0;

  for (int trial = 0; trial < kTrials; ++trial) {
    KnownPitch pitch(Noise::kReal, static_cast<std::uint64_t>(trial));
    pitch.place_self({-20.0, 0.0}, random.uniform(-180.0, 180.0));
    pitch.place_ball(Vec2{-20.0, 0.0} + around(random, 0.5, 0.8));
    cycles += pitch.act_until(
        80,
        [&](PlayerActions& reply) {
          reply.set_ignore_dointention(false);
          auto& dribble = *reply.add_actions()->mutable_body_dribble();
          set(dribble.mutable_target_point(), target);
          dribble.set_distance_threshold(1.0F);
          dribble.set_dash_power(100.0F);
          dribble.set_dash_count(5);
        },
        [&] { return distance(pitch.world.self.position, target) < 1.5; });
    arrived += distance(pitch.world.ball.position, target) < 4.0 ? 1 : 0;
  }

  EXPECT_GE(arrived, 49);
  // A run without the ball takes 31 cycles and a turn.
  EXPECT_LT(cycles, 42 * kTrials);
}

TEST(UnderNoise, InterceptReachesBallNearlyOptimally) {
  soccer::RandomStream random(3, "intercept");
  constexpr int kTrials = 100;
  int got = 0;
  int cycles = 0;
  int quickest = 0;

  for (int trial = 0; trial < kTrials; ++trial) {
    KnownPitch pitch(Noise::kReal, static_cast<std::uint64_t>(trial));
    pitch.place_self({}, random.uniform(-180.0, 180.0));
    pitch.place_ball(around(random, 3.0, 15.0), around(random, 0.0, 2.0));
    quickest += pitch.world.intercept.self_steps;
    cycles += pitch.act_until(
        60,
        [](PlayerActions& reply) {
          auto& go = *reply.add_actions()->mutable_body_intercept();
          go.set_save_recovery(true);
          set(go.mutable_face_point(), {52.5, 0.0});
        },
        [&] { return pitch.world.self.kickable; });
    got += pitch.world.self.kickable ? 1 : 0;
  }

  EXPECT_EQ(got, kTrials);
  EXPECT_LT(cycles, quickest * 1.25);
}

TEST(UnderNoise, HoldBallShieldsBallFromTwoOpponents) {
  soccer::RandomStream random(4, "hold");
  int lost = 0;
  for (int trial = 0; trial < 30; ++trial) {
    KnownPitch pitch(Noise::kReal, static_cast<std::uint64_t>(trial));
    pitch.place_self({}, random.uniform(-180.0, 180.0));
    pitch.place_ball(around(random, 0.5, 0.7));
    pitch.add_opponent(4, around(random, 1.7, 2.0));
    pitch.add_opponent(5, around(random, 2.1, 2.4));
    for (int cycle = 0; cycle < 20; ++cycle) {
      pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_body_hold_ball(); });
      if (cycle > 1 && (pitch.world.kickable_opponent() || !pitch.world.self.kickable)) ++lost;
    }
  }

  EXPECT_LE(lost, 6) << "of 540 cycles";
}

TEST(UnderNoise, GoToPointStopsAtTarget) {
  soccer::RandomStream random(5, "go to point");
  for (int trial = 0; trial < 50; ++trial) {
    KnownPitch pitch(Noise::kReal, static_cast<std::uint64_t>(trial));
    pitch.place_self({}, random.uniform(-180.0, 180.0));

    const Vec2 target = around(random, 0.6, 20.0);
    const int cycles = pitch.act_until(
        60,
        [&](PlayerActions& reply) {
          auto& go = *reply.add_actions()->mutable_body_go_to_point();
          set(go.mutable_target_point(), target);
          go.set_distance_threshold(0.3F);
          go.set_max_dash_power(100.0F);
        },
        [&] {
          return distance(pitch.world.self.position, target) < 0.3 &&
                 pitch.world.self.velocity.length() < 0.1;
        });
    EXPECT_LT(cycles, target.length() + 12.0) << trial;
  }
}

}  // namespace
}  // namespace cls::proxy
