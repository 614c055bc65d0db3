// Kicks, dribbles and tackles: the resulting ball motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "player/ball_skills/ball_skills.h"
#include "player/movement/home_positions.h"
#include "player/world/motion.h"
#include "tests/proxy/support/wire_vector.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using protos::PlayerAction;
using soccer::AngleDeg;
using soccer::PlayMode;
using soccer::Vec2;
using tests::KnownPitch;
using tests::Noise;
using tests::set;

auto smart_kick_to(Vec2 target, double speed, double threshold, int steps) {
  return [=](protos::PlayerActions& reply) {
    auto& kick = *reply.add_actions()->mutable_body_smart_kick();
    set(kick.mutable_target_point(), target);
    kick.set_first_speed(static_cast<float>(speed));
    kick.set_first_speed_threshold(static_cast<float>(threshold));
    kick.set_max_steps(steps);
  };
}

auto kick_one_step_to(Vec2 target, double speed, bool force) {
  return [=](protos::PlayerActions& reply) {
    auto& kick = *reply.add_actions()->mutable_body_kick_one_step();
    set(kick.mutable_target_point(), target);
    kick.set_first_speed(static_cast<float>(speed));
    kick.set_force_mode(force);
  };
}

/// Degrees between the ball direction and the line to `target`.
double off_course(const KnownPitch& pitch, Vec2 from, Vec2 target) {
  return (AngleDeg::of(pitch.world.ball.velocity) - AngleDeg::of(target - from)).abs();
}

struct SmartCase {
  Vec2 ball;
  Vec2 ball_velocity;
  Vec2 velocity;
  double body;
  Vec2 target;
  double speed;
};

void PrintTo(const SmartCase& one, std::ostream* out) {
  *out << fmt::format("from ({}, {}) to ({}, {}) at {}", one.ball.x, one.ball.y, one.target.x,
                      one.target.y, one.speed);
}

class SmartKick : public testing::TestWithParam<SmartCase> {};

TEST_P(SmartKick, ReachesDesiredSpeedWithinThreeKicks) {
  const SmartCase& c = GetParam();
  KnownPitch pitch;
  pitch.place_self({}, c.body, c.velocity);
  pitch.place_ball(c.ball, c.ball_velocity);

  ASSERT_TRUE(pitch.world.self.kickable);
  const double decay = pitch.world.server().ball_decay;
  Vec2 from;

  int kicks = 0;
  do {
    from = pitch.world.ball.position;
    pitch.act(smart_kick_to(c.target, c.speed, c.speed * 0.95, 3));
    ++kicks;
  } while (kicks < 3 && pitch.world.ball.velocity.length() / decay < c.speed * 0.95);

  EXPECT_NEAR(pitch.world.ball.velocity.length() / decay, c.speed, 0.05 * c.speed);
  EXPECT_LT(off_course(pitch, from, c.target), 1.0);
  EXPECT_FALSE(pitch.touched_ball());
  EXPECT_EQ(pitch.counts(PlayerAction::kBodySmartKick).failed, 0);
}

INSTANTIATE_TEST_SUITE_P(
    BallPositions, SmartKick,
    testing::Values(SmartCase{{0.6, 0.0}, {}, {}, 0.0, {30, 0}, 2.4},
                    SmartCase{{0.6, 0.0}, {}, {}, 0.0, {30, 0}, 3.0},
                    SmartCase{{0.6, 0.0}, {}, {}, 0.0, {-30, 0}, 2.8},
                    SmartCase{{-0.5, 0.5}, {0.3, -0.2}, {0.2, 0.1}, 45.0, {10, 40}, 2.7},
                    SmartCase{{0.0, 0.9}, {0.1, -0.5}, {}, 90.0, {20, -20}, 2.5},
                    SmartCase{{0.7, 0.2}, {-0.4, 0.0}, {0.3, 0.0}, 10.0, {25, 10}, 1.2}));

TEST(BodySmartKick, HoldsBallWhenSpeedIsUnreachable) {
  KnownPitch pitch;
  pitch.place_ball({0.9, 0.4});
  pitch.act(smart_kick_to({-30.0, 0.0}, 3.0, 3.0, 1));
  EXPECT_EQ(pitch.counts(PlayerAction::kBodySmartKick).failed, 1);
  EXPECT_TRUE(pitch.world.self.kickable);
  KnownPitch far;
  far.act(smart_kick_to({-30.0, 0.0}, 3.0, 0.0, 3));
  EXPECT_EQ(far.counts(PlayerAction::kBodySmartKick).failed, 1) << "not kickable";
}

TEST(BodySmartKick, AvoidsOpponentsWithIntermediateKicks) {
  // The path back over the left side passes an opponent.
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.add_opponent(5, {-0.6, -1.4}, 90.0);
  for (int kick = 0; kick < 3; ++kick) {
    pitch.act(smart_kick_to({-30.0, 15.0}, 2.6, 2.3, 3));
    ASSERT_FALSE(pitch.world.kickable_opponent()) << kick;
    if (!pitch.world.self.kickable) break;
  }
  EXPECT_LT(pitch.world.ball.velocity.x, -1.5);
}

TEST(BodyKickOneStep, SetsBallSpeedAndDirection) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.2}, {0.2, -0.3});
  pitch.act(kick_one_step_to({20.0, 10.0}, 1.5, false));
  EXPECT_NEAR(pitch.world.ball.velocity.length(), 1.5 * 0.94, 0.01);
  EXPECT_LT(off_course(pitch, {0.6, 0.2}, {20.0, 10.0}), 0.5);
}

TEST(BodyKickOneStep, KicksWithForceModeAndHoldsWithoutWhenDirectionIsImpossible) {
  // One kick cannot turn a fast ball around.
  KnownPitch forced;
  forced.place_ball({0.9, 0.0}, {0.0, 2.6});
  forced.act(kick_one_step_to({0.9, -30.0}, 2.5, true));
  EXPECT_DOUBLE_EQ(forced.sent<soccer::Kick>()->power, 100.0);
  KnownPitch held;
  held.place_ball({0.9, 0.0}, {2.4, 0.0});
  held.act(kick_one_step_to({0.9, -30.0}, 2.5, false));
  EXPECT_LT(held.world.ball.velocity.length(), 1.5);
}

TEST(BodyStopBall, KeepsBallBesideMovingPlayer) {
  KnownPitch pitch;
  pitch.place_self({}, 0.0, {0.4, 0.0});
  pitch.place_ball({0.3, 0.6}, {0.9, 0.5});
  pitch.act([](protos::PlayerActions& reply) { reply.add_actions()->mutable_body_stop_ball(); });
  const Vec2 relative = pitch.world.ball.position - pitch.world.self.position;
  EXPECT_NEAR(relative.x, 0.3, 0.02);
  EXPECT_NEAR(relative.y, 0.6, 0.02);
}

TEST(BodyStopBall, FailsForBallAtRest) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.act([](protos::PlayerActions& reply) { reply.add_actions()->mutable_body_stop_ball(); });
  EXPECT_EQ(pitch.counts(PlayerAction::kBodyStopBall).failed, 1);
  EXPECT_EQ(pitch.sent<soccer::Kick>(), nullptr);
}

TEST(BodyHoldBall, KeepsBallAwayFromOpponent) {
  KnownPitch pitch;
  pitch.place_ball({0.5, 0.3});
  pitch.add_opponent(4, {1.7, 0.3});

  for (int i = 0; i < 20; ++i) {
    pitch.act([](protos::PlayerActions& reply) {
      reply.add_actions()->mutable_body_hold_ball()->set_do_turn(false);
    });
    ASSERT_TRUE(pitch.world.self.kickable) << i;
    if (i > 0) {
      EXPECT_FALSE(pitch.world.kickable_opponent()) << i;
    }
  }

  EXPECT_LT(pitch.world.ball.position.x, 0.2) << "behind the own body";
}

TEST(BodyHoldBall, TurnsToTargetPointWhenBallIsSafe) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  for (int i = 0; i < 5; ++i) {
    pitch.act([](protos::PlayerActions& reply) {
      auto& hold = *reply.add_actions()->mutable_body_hold_ball();
      hold.set_do_turn(true);
      set(hold.mutable_turn_target_point(), {0.0, -20.0});
    });
    ASSERT_TRUE(pitch.world.self.kickable) << i;
  }
  EXPECT_NEAR(pitch.world.self.body.degrees(), -90.0, 5.0);
}

auto dribble_to(Vec2 target, int dashes) {
  return [=](protos::PlayerActions& reply) {
    reply.set_ignore_dointention(false);
    auto& dribble = *reply.add_actions()->mutable_body_dribble();
    set(dribble.mutable_target_point(), target);
    dribble.set_distance_threshold(1.0F);
    dribble.set_dash_power(100.0F);
    dribble.set_dash_count(dashes);
    dribble.set_dodge(true);
  };
}

TEST(BodyDribble, CarriesBallToTarget) {
  for (const double body : {0.0, 100.0, 180.0}) {
    for (const int dashes : {1, 3, 8}) {
      KnownPitch pitch;
      pitch.place_self({}, body);
      pitch.place_ball({0.5, -0.3});

      double farthest = 0.0;
      const int cycles = pitch.act_until(60, dribble_to({20.0, 6.0}, dashes), [&] {
        farthest = std::max(farthest, pitch.world.ball.dist_from_self);
        return distance(pitch.world.self.position, {20.0, 6.0}) < 1.5;
      });

      EXPECT_LT(cycles, 48) << body << " " << dashes;
      EXPECT_LT(farthest, 1.2 + 0.5 * dashes) << body << " " << dashes;
      EXPECT_FALSE(pitch.touched_ball()) << body << " " << dashes;
      EXPECT_LT(pitch.world.ball.dist_from_self, 4.0);
      if (dashes > 1) {
        EXPECT_GT(pitch.report.intention, 0);
      }
    }
  }
}

// A ball at the feet whose velocity was never seen: the player must not wait for it.
TEST(BodyDribble, StartsWithARestingBallOfUnknownVelocity) {
  KnownPitch pitch;
  pitch.place_self({}, 122.0);
  pitch.place_ball({0.5, 0.0});
  pitch.world.ball.vel_count = player::kNever;
  protos::PlayerActions reply;
  dribble_to({20.0, 0.0}, 4)(reply);
  pitch.act(reply);
  const auto* turn = pitch.sent<soccer::Turn>();
  const bool turns = turn != nullptr && std::fabs(turn->moment) > 10.0;
  EXPECT_TRUE(turns || pitch.sent<soccer::Kick>() != nullptr);
}

TEST(BodyDribble, InterceptsBallFirst) {
  KnownPitch pitch;
  pitch.place_ball({6.0, 3.0});
  const int cycles =
      pitch.act_until(20, dribble_to({20.0, 0.0}, 2), [&] { return pitch.world.self.kickable; });
  EXPECT_LT(cycles, 12);
}

TEST(BodyAdvanceBall, KicksUpfieldIntoFreeSpace) {
  KnownPitch pitch;
  pitch.place_self({-10.0, 5.0}, 0.0);
  pitch.place_ball({-9.4, 5.0});
  pitch.add_opponent(3, {0.0, 5.0});
  pitch.add_opponent(4, {0.0, 12.0});
  pitch.act_until(
      3, [](protos::PlayerActions& reply) { reply.add_actions()->mutable_body_advance_ball(); },
      [&] { return pitch.world.ball.velocity.length() > 1.8; });

  EXPECT_GT(pitch.world.ball.velocity.x, 0.7);
  pitch.roll(10);

  for (const player::PlayerState& opponent : pitch.world.opponents) {
    EXPECT_GT(opponent.dist_from_ball, 2.0);
  }
}

TEST(BodyClearBall, KicksUpfieldTowardTouchLine) {
  KnownPitch pitch;
  pitch.place_self({-40.0, 8.0}, 0.0);
  pitch.place_ball({-39.5, 8.3});
  pitch.act_until(
      3, [](protos::PlayerActions& reply) { reply.add_actions()->mutable_body_clear_ball(); },
      [&] { return pitch.world.ball.velocity.length() > 2.0; });
  const Vec2 velocity = pitch.world.ball.velocity;
  EXPECT_GT(velocity.length(), 2.0);
  EXPECT_GT(velocity.x, 1.0);
  EXPECT_GT(velocity.y, 0.5);
}

TEST(BodyClearBall, KicksImmediatelyWhenOpponentCanKick) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.add_opponent(4, {1.4, 0.4});
  pitch.act([](protos::PlayerActions& reply) { reply.add_actions()->mutable_body_clear_ball(); });
  EXPECT_GT(pitch.world.ball.velocity.x, 1.8);
}

TEST(HeliosGoalieKick, ClearsBall) {
  KnownPitch pitch;
  pitch.make_goalie();
  pitch.place_self({-48.0, 2.0}, 0.0);
  pitch.place_ball({-47.5, 2.0});
  pitch.act_until(
      3, [](protos::PlayerActions& reply) { reply.add_actions()->mutable_helios_goalie_kick(); },
      [&] { return pitch.world.ball.velocity.length() > 2.0; });
  EXPECT_GT(pitch.world.ball.velocity.x, 1.0);
}

TEST(BhvDoForceKick, KicksContestedBallTowardGoal) {
  KnownPitch pitch;
  pitch.place_ball({0.5, 0.0});
  const auto force = [](protos::PlayerActions& reply) {
    reply.add_actions()->mutable_bhv_do_force_kick();
  };
  pitch.act(force);
  EXPECT_EQ(pitch.counts(PlayerAction::kBhvDoForceKick).failed, 1) << "no opponent near the ball";
  pitch.add_opponent(4, {1.2, 0.3});
  pitch.act(force);
  EXPECT_GT(pitch.world.ball.velocity.x, 1.8);
  EXPECT_NEAR(pitch.world.ball.velocity.y, 0.0, 0.1);
}

TEST(BhvDoForceKick, KicksOutwardsBesideOurGoal) {
  for (const double side : {1.0, -1.0}) {
    KnownPitch pitch;
    pitch.place_self({-50.0, 17.0 * side}, 90.0 * side);
    pitch.place_ball({-50.0, 17.5 * side});
    pitch.add_opponent(11, {-50.0, 18.2 * side});
    pitch.act(
        [](protos::PlayerActions& reply) { reply.add_actions()->mutable_bhv_do_force_kick(); });
    EXPECT_GT(pitch.world.ball.velocity.y * side, 1.0);
  }
}

TEST(HeliosShoot, ScoresPastGoalie) {
  KnownPitch pitch;
  pitch.place_self({40.0, 3.0}, 0.0);
  pitch.place_ball({40.6, 3.0});
  pitch.add_opponent(1, {51.0, 2.5});
  const auto fill = [](protos::PlayerActions& reply) {
    reply.add_actions()->mutable_helios_shoot();
  };
  pitch.act_until(3, fill, [&] { return pitch.world.ball.velocity.length() > 2.0; });
  Vec2 ball = pitch.world.ball.position;
  double nearest = 100.0;

  while (ball.x < 52.5 && pitch.world.ball.velocity.length() > 0.1) {
    pitch.roll(1);
    ball = pitch.world.ball.position;
    nearest = std::min(nearest, distance(ball, {51.0, 2.5}));
  }

  EXPECT_GT(ball.x, 52.4);
  EXPECT_LT(std::fabs(ball.y), 7.01);
  EXPECT_GT(nearest, 1.2) << "out of the goalie's hands";
}

TEST(HeliosShoot, FailsWhenGoalieCanStopShot) {
  KnownPitch pitch;
  pitch.place_self({30.0, 20.0}, 0.0);
  pitch.place_ball({30.6, 20.0});
  pitch.add_opponent(1, {50.0, 2.5});
  pitch.add_opponent(2, {45.0, 8.0});
  pitch.add_opponent(3, {42.0, 12.0});
  pitch.act([](protos::PlayerActions& reply) { reply.add_actions()->mutable_helios_shoot(); });

  EXPECT_EQ(pitch.counts(PlayerAction::kHeliosShoot).failed, 1);
  KnownPitch far;
  far.place_ball({0.6, 0.0});
  far.act([](protos::PlayerActions& reply) { reply.add_actions()->mutable_helios_shoot(); });

  EXPECT_EQ(far.counts(PlayerAction::kHeliosShoot).failed, 1);
}

TEST(BodyTackleToPoint, SendsBallToPoint) {
  KnownPitch pitch;
  pitch.place_ball({1.5, 0.2});
  pitch.act([](protos::PlayerActions& reply) {
    auto& tackle = *reply.add_actions()->mutable_body_tackle_to_point();
    set(tackle.mutable_target_point(), {20.0, 15.0});
    tackle.set_min_probability(0.6F);
    tackle.set_min_speed(1.0F);
  });
  EXPECT_GT(pitch.world.ball.velocity.length(), 1.0);
  EXPECT_LT(off_course(pitch, {1.5, 0.2}, {20.0, 15.0}), 2.0);
}

TEST(BodyTackleToPoint, FailsBelowMinimumProbabilityOrSpeed) {
  const auto tackle_with = [](float probability, float speed) {
    return [=](protos::PlayerActions& reply) {
      auto& tackle = *reply.add_actions()->mutable_body_tackle_to_point();
      set(tackle.mutable_target_point(), {-20.0, 0.0});
      tackle.set_min_probability(probability);
      tackle.set_min_speed(speed);
    };
  };

  KnownPitch pitch;
  pitch.place_ball({1.9, 0.9});
  pitch.act(tackle_with(0.9F, 0.0F));
  pitch.place_ball({1.0, 0.0});
  pitch.act(tackle_with(0.9F, 1.0F));

  EXPECT_EQ(pitch.counts(PlayerAction::kBodyTackleToPoint).failed, 2);
}

void basic_tackle(protos::PlayerActions& reply) {
  reply.add_actions()->mutable_helios_basic_tackle()->set_min_prob(0.7F);
}

TEST(HeliosBasicTackle, TakesBallFromOpponent) {
  int taken = 0;
  for (int seed = 0; seed < 20; ++seed) {
    KnownPitch pitch(Noise::kReal, static_cast<std::uint64_t>(seed));
    pitch.place_self({-45.0, 0.0});
    pitch.place_ball({-43.6, 0.0});
    pitch.act(basic_tackle);
    EXPECT_EQ(pitch.counts(PlayerAction::kHeliosBasicTackle).failed, 1) << "no opponent to tackle";
    pitch.add_opponent(4, {-43.0, 0.2});
    pitch.act(basic_tackle);
    ASSERT_NE(pitch.sent<soccer::Tackle>(), nullptr);
    EXPECT_FALSE(pitch.sent<soccer::Tackle>()->foul) << "not in the own penalty area";
    pitch.roll(1);
    taken += pitch.world.kickable_opponent() ? 0 : 1;
  }

  // It succeeds with 1 - 0.7^6 = 0.88.
  EXPECT_GE(taken, 14);
}

TEST(HeliosBasicTackle, SendsBallToTeammate) {
  for (const double side : {1.0, -1.0}) {
    KnownPitch pitch;
    pitch.place_ball({1.3, 0.0});
    pitch.add_opponent(4, {2.1, 0.1 * side}, 180.0);
    pitch.add_teammate(8, {3.0, 9.0 * side});
    pitch.add_opponent(6, {4.0, -9.0 * side});
    pitch.set_parameter("fouls", 1);  // the opponent with the ball cannot follow it
    pitch.act(basic_tackle);
    ASSERT_NE(pitch.sent<soccer::Tackle>(), nullptr);
    EXPECT_GT(pitch.sent<soccer::Tackle>()->angle_or_power * side, 0.0);
  }
}

TEST(HeliosBasicTackle, AvoidsFoulsNearOurGoal) {
  const auto tackles = [](Vec2 self, Vec2 opponent, double opponent_body) {
    KnownPitch pitch;
    pitch.place_self(self, opponent.x > 0.0 ? 0.0 : 180.0);
    pitch.place_ball(self + Vec2{opponent.x > 0.0 ? 1.4 : -1.4, 0.0});
    pitch.add_opponent(9, self + opponent, opponent_body);
    pitch.act(basic_tackle);
    return pitch.sent<soccer::Tackle>() != nullptr;
  };

  const Vec2 before_goal{-45.0, 3.0};
  EXPECT_FALSE(tackles(before_goal, {0.9, 0.1}, 10.0)) << "through the opponent's back";
  EXPECT_TRUE(tackles(before_goal, {2.0, 0.1}, 180.0)) << "the ball is between the players";
  EXPECT_TRUE(tackles(before_goal, {-0.9, 0.1}, 175.0)) << "the opponent is about to shoot";
  EXPECT_TRUE(tackles({-20.0, 3.0}, {0.9, 0.1}, 10.0)) << "far from our goal";
}

TEST(HeliosBasicTackle, FoulsOnlyIfTheParametersSaySo) {
  for (const int fouls : {0, 1}) {
    KnownPitch pitch;
    pitch.set_parameter("fouls", fouls);
    pitch.place_ball({1.4, 0.0});
    pitch.add_opponent(4, {2.0, 0.2});
    pitch.act(basic_tackle);
    ASSERT_NE(pitch.sent<soccer::Tackle>(), nullptr);
    EXPECT_EQ(pitch.sent<soccer::Tackle>()->foul, fouls == 1);
  }
}

TEST(HeliosBasicMove, InterceptsBallOrRunsToHomePosition) {
  KnownPitch nearest;
  nearest.place_ball({5.0, 3.0});
  nearest.add_teammate(10, {20.0, 20.0});
  const auto fill = [](protos::PlayerActions& reply) {
    reply.add_actions()->mutable_helios_basic_move();
  };

  EXPECT_LT(nearest.act_until(12, fill, [&] { return nearest.world.self.kickable; }), 12);
  KnownPitch idle;
  idle.place_self({-40.0, 30.0});
  idle.place_ball({0.0, 0.0});
  idle.add_teammate(10, {0.6, 0.0});
  for (int i = 0; i < 100; ++i) idle.act(fill);
  const Vec2 home = home_positions(idle.world)[6];

  EXPECT_LT(distance(idle.world.self.position, home), 0.1 * idle.world.ball.dist_from_self + 0.5);
}

}  // namespace
}  // namespace cls::proxy
