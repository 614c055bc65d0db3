// Running and turning: final position and body direction.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/proxy/support/wire_vector.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using protos::PlayerAction;
using soccer::AngleDeg;
using soccer::PlayMode;
using soccer::Vec2;
using tests::KnownPitch;
using tests::set;

std::function<void(protos::PlayerActions&)> go_to(Vec2 target, double threshold,
                                                  double power = 100.0) {
  return [=](protos::PlayerActions& reply) {
    auto& go = *reply.add_actions()->mutable_body_go_to_point();
    set(go.mutable_target_point(), target);
    go.set_distance_threshold(static_cast<float>(threshold));
    go.set_max_dash_power(static_cast<float>(power));
  };
}

struct GoToCase {
  Vec2 from;
  double body;
  Vec2 velocity;
  Vec2 target;
  double threshold;
};

void PrintTo(const GoToCase& one, std::ostream* out) {
  *out << fmt::format("from ({}, {}) facing {} to ({}, {})", one.from.x, one.from.y, one.body,
                      one.target.x, one.target.y);
}

class GoToPoint : public testing::TestWithParam<GoToCase> {};

TEST_P(GoToPoint, ReachesPointAndStops) {
  const GoToCase& c = GetParam();
  KnownPitch pitch;
  pitch.place_self(c.from, c.body, c.velocity);
  const double way = distance(c.from, c.target);
  const auto there = [&] {
    return distance(pitch.world.self.position, c.target) < c.threshold &&
           pitch.world.self.velocity.length() < 0.05;
  };
  const int cycles = pitch.act_until(100, go_to(c.target, c.threshold), there);

  // Two turns, acceleration and braking in addition to one meter per cycle.
  EXPECT_LE(cycles, static_cast<int>(way) + 9);
  EXPECT_TRUE(there());

  for (int i = 0; i < 10; ++i) pitch.act(go_to(c.target, c.threshold));
  EXPECT_LT(distance(pitch.world.self.position, c.target), c.threshold);
  EXPECT_EQ(pitch.sent<soccer::Turn>()->moment, 0.0);
  EXPECT_GT(pitch.counts(PlayerAction::kBodyGoToPoint).failed, 0) << "arrived counts as failed";
}

INSTANTIATE_TEST_SUITE_P(Starts, GoToPoint,
                         testing::Values(GoToCase{{0, 0}, 0.0, {}, {10, 0}, 0.5},
                                         GoToCase{{0, 0}, 180.0, {}, {10, 3}, 0.5},
                                         GoToCase{{0, 0}, 90.0, {0.0, 0.4}, {-7, -7}, 0.3},
                                         GoToCase{{0, 0}, 0.0, {}, {0.3, 0.9}, 0.2},
                                         GoToCase{{0, 0}, 0.0, {}, {-1.5, 0.1}, 0.3},
                                         GoToCase{{-30, 20}, -45.0, {0.2, 0.1}, {20, -15}, 1.0},
                                         GoToCase{{0, 0}, 0.0, {0.4, 0.0}, {0.6, 0}, 0.1},
                                         // A goal post is in the way.
                                         GoToCase{{-51.0, 8.5}, -90.0, {}, {-52.9, 5.0}, 0.4}));

TEST(BodyGoToPoint, LimitsPowerAndPreservesRecovery) {
  KnownPitch pitch;
  pitch.act(go_to({20.0, 0.0}, 0.5, 40.0));
  EXPECT_DOUBLE_EQ(pitch.sent<soccer::Dash>()->power, 40.0);
  pitch.set_stamina(0.3 * 8000.0 + 11.0);
  pitch.act(go_to({20.0, 0.0}, 0.5, 100.0));
  EXPECT_LE(pitch.sent<soccer::Dash>()->power, 10.0 + 1e-9);
  pitch.act(go_to({20.0, 0.0}, 0.5, 0.0));
  EXPECT_EQ(pitch.sent<soccer::Turn>()->moment, 0.0);
}

TEST(BodyGoToPointDodge, RunsAroundPlayerInTheWay) {
  KnownPitch pitch;
  pitch.add_opponent(4, {4.0, 0.05});
  double nearest = 100.0;

  const int cycles = pitch.act_until(
      25,
      [](protos::PlayerActions& reply) {
        auto& go = *reply.add_actions()->mutable_body_go_to_point_dodge();
        set(go.mutable_target_point(), {9.0, 0.0});
        go.set_dash_power(100.0F);
      },
      [&] {
        nearest = std::min(nearest, pitch.world.opponents[0].dist_from_self);
        return distance(pitch.world.self.position, {9.0, 0.0}) < 0.6;
      });

  EXPECT_LT(cycles, 25);
  EXPECT_GT(nearest, 0.6) << "two player radii";
}

TEST(BhvGoToPointLookBall, ArrivesWithBallInView) {
  for (const Vec2 target : {Vec2{8.0, 0.0}, Vec2{-8.0, 0.0}, Vec2{0.0, -9.0}}) {
    KnownPitch pitch;
    pitch.place_ball({12.0, 9.0});
    const auto go = [&](protos::PlayerActions& reply) {
      auto& look = *reply.add_actions()->mutable_bhv_go_to_point_look_ball();
      set(look.mutable_target_point(), target);
      look.set_distance_threshold(0.8F);
      look.set_max_dash_power(100.0F);
    };
    int unseen = 0;
    const int cycles = pitch.act_until(40, go, [&] {
      unseen += pitch.sees(pitch.world.ball.position) ? 0 : 1;
      return distance(pitch.world.self.position, target) < 0.8;
    });
    EXPECT_LT(cycles, 30) << target.x;
    EXPECT_LE(unseen, 3) << target.x;
  }
}

TEST(BodyStopDash, StopsPlayer) {
  KnownPitch pitch;
  pitch.place_self({}, -30.0, {0.3, -0.2});
  const auto stop = [](protos::PlayerActions& reply) {
    reply.add_actions()->mutable_body_stop_dash()->set_save_recovery(true);
  };
  pitch.act(stop);
  EXPECT_LT(pitch.world.self.velocity.length(), 0.02);
  EXPECT_LT(pitch.world.self.position.length(), 0.03);
  pitch.act(stop);
  pitch.act(stop);
  EXPECT_EQ(pitch.counts(PlayerAction::kBodyStopDash).failed, 2) << "nothing left to stop";
}

TEST(BodyTurnToAngle, FacesAngleWhileMoving) {
  KnownPitch pitch;
  pitch.place_self({}, -120.0, {0.2, 0.0});
  for (int i = 0; i < 3; ++i) {
    pitch.act([](protos::PlayerActions& reply) {
      reply.add_actions()->mutable_body_turn_to_angle()->set_angle(100.0F);
    });
  }
  EXPECT_NEAR(pitch.world.self.body.degrees(), 100.0, 0.1);
}

TEST(BodyTurnToPoint, FacesPointFromCoastingPosition) {
  KnownPitch pitch;
  pitch.place_self({}, 0.0, {0.2, 0.0});
  const auto turn = [](protos::PlayerActions& reply) {
    auto& point = *reply.add_actions()->mutable_body_turn_to_point();
    set(point.mutable_target_point(), {0.2, 5.0});
    point.set_cycle(1);
  };

  pitch.act(turn);
  EXPECT_NEAR(pitch.world.self.body.degrees(), 90.0, 0.1);

  pitch.place_self({0.2, 0.0}, 90.0);
  pitch.act(turn);
  EXPECT_EQ(pitch.counts(PlayerAction::kBodyTurnToPoint).failed, 1) << "already facing it";
}

TEST(BodyTurnToBall, FacesPredictedBallPosition) {
  KnownPitch pitch;
  pitch.place_ball({10.0, -1.0}, {0.0, 1.0});
  pitch.act([](protos::PlayerActions& reply) {
    reply.add_actions()->mutable_body_turn_to_ball()->set_cycle(2);
  });
  EXPECT_NEAR(pitch.world.self.body.degrees(), AngleDeg::of({10.0, 0.94}).degrees(), 0.1);
}

TEST(BhvBeforeKickOff, MovesToPointAndScans) {
  KnownPitch pitch;
  pitch.set_mode(PlayMode::kBeforeKickOff);
  pitch.set_time(0, 8);
  const auto wait = [](protos::PlayerActions& reply) {
    set(reply.add_actions()->mutable_bhv_before_kick_off()->mutable_point(), {-20.0, 12.0});
  };
  pitch.act(wait);

  EXPECT_LT(distance(pitch.world.self.position, {-20.0, 12.0}), 0.01);

  // After arriving it scans all directions.
  std::array<bool, 36> seen{};
  for (int i = 0; i < 20; ++i) {
    pitch.act(wait);
    for (int d = 0; d < 36; ++d) {
      seen[d] = seen[d] ||
                pitch.sees(pitch.world.self.position + soccer::polar_degrees(9.0, d * 10.0 + 3.0));
    }
  }

  EXPECT_EQ(std::ranges::count(seen, true), 36);
}

TEST(BhvBeforeKickOff, StaysOutOfCenterCircleWithoutKickOff) {
  const auto wait = [](protos::PlayerActions& reply) {
    set(reply.add_actions()->mutable_bhv_before_kick_off()->mutable_point(), {3.0, 1.0});
  };
  KnownPitch kicker;
  kicker.place_self({-20.0, 0.0});
  kicker.set_mode(PlayMode::kBeforeKickOff);
  kicker.set_time(0, 8);
  kicker.act(wait);

  EXPECT_NEAR(kicker.world.self.position.x, -0.01, 1e-6);
  KnownPitch other;
  other.place_self({-20.0, 0.0});
  other.world.our_side = soccer::Side::kRight;
  other.set_mode(PlayMode::kBeforeKickOff);
  other.set_time(0, 8);
  other.act(wait);

  EXPECT_NEAR(other.world.self.position.length(), 9.65, 0.01);
}

auto intercept_facing(Vec2 point) {
  return [=](protos::PlayerActions& reply) {
    auto& go = *reply.add_actions()->mutable_body_intercept();
    go.set_save_recovery(true);
    set(go.mutable_face_point(), point);
  };
}

TEST(BodyIntercept, ReachesRollingBall) {
  for (const double body : {0.0, 120.0, -90.0}) {
    KnownPitch pitch;
    pitch.place_self({0.0, -6.0}, body);
    pitch.place_ball({-15.0, 0.0}, {1.8, 0.0});
    const int quickest = pitch.world.intercept.self_steps;
    const int cycles = pitch.act_until(40, intercept_facing({52.5, 0.0}),
                                       [&] { return pitch.world.self.kickable; });
    EXPECT_LE(cycles, quickest + 1) << body;
  }
}

TEST(BodyIntercept, ReachesBallQuicklyNearOpponent) {
  KnownPitch pitch;
  pitch.place_self({0.0, -6.0}, 0.0);
  pitch.place_ball({-15.0, 0.0}, {1.8, 0.0});
  pitch.add_opponent(5, {8.0, 6.0});
  const int quickest = pitch.world.intercept.self_steps;
  const int cycles =
      pitch.act_until(40, intercept_facing({52.5, 0.0}), [&] { return pitch.world.self.kickable; });
  EXPECT_LE(cycles, quickest + 1);
}

TEST(BodyIntercept, WaitsForApproachingBall) {
  KnownPitch pitch;
  pitch.place_self({0.0, 0.2}, 180.0);
  pitch.place_ball({-2.0, 0.0}, {1.5, 0.0});
  pitch.act(intercept_facing({-20.0, 30.0}));
  ASSERT_NE(pitch.sent<soccer::Turn>(), nullptr);
  EXPECT_NEAR(pitch.world.self.body.degrees(), AngleDeg::of({-20.0, 29.8}).degrees(), 0.1);
}

TEST(BodyIntercept, RunsToRestPointOfUnreachableBall) {
  KnownPitch pitch;
  pitch.place_self({-45.0, 0.0});
  pitch.place_ball({20.0, 0.0}, {1.2, 0.0});
  ASSERT_TRUE(pitch.world.intercept.plans.empty());
  pitch.act(intercept_facing({0.0, 0.0}));
  EXPECT_NE(pitch.sent<soccer::Dash>(), nullptr);
}

}  // namespace
}  // namespace cls::proxy
