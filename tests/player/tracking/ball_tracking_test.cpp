// Ball tracking: rolling, kicked, missing, placed by the referee.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "player/perception/perception.h"
#include "player/world/motion.h"
#include "soccer/pitch.h"
#include "soccer/random.h"
#include "tests/player/tracking/synthetic_senses.h"

namespace cls::player {
namespace {

using tests::TrueWorld;

/// An observer in the middle of its half facing +x, and a ball.
struct Scene {
  TrueWorld truth;
  WorldModel world;
  soccer::CommandCounts counts;

  explicit Scene(Vec2 ball, Vec2 velocity = {}, Side side = Side::kLeft) {
    on_init(world, {side, 7, PlayMode::kPlayOn},
            side == Side::kLeft ? tests::kLeftTeam : tests::kRightTeam, false);
    truth.self.position = {-20.0, 3.0};
    truth.width = soccer::ViewWidth::kWide;
    truth.ball = ball;
    truth.ball_velocity = velocity;
  }

  void sense() {
    soccer::SenseBody sense = tests::sense_of(truth);
    sense.counts = counts;
    on_sense_body(world, sense);
  }
  void look() {
    sense();
    on_see(world, tests::see_of(truth));
  }

  /// One cycle of an untouched ball, with noise drawn as the server does.
  void roll(soccer::RandomStream& random) {
    ++truth.time;
    const double speed = truth.ball_velocity.length();
    truth.ball_velocity +=
        soccer::polar_degrees(random.uniform(0.0, 0.05 * speed), random.uniform(-180.0, 180.0));
    truth.ball += truth.ball_velocity;
    truth.ball_velocity *= 0.94;
  }

  Vec2 own(Vec2 v) const { return world.our_side == Side::kRight ? -v : v; }
  double position_error() const { return soccer::distance(world.ball.position, own(truth.ball)); }
  double velocity_error() const {
    return soccer::distance(world.ball.velocity, own(truth.ball_velocity));
  }
};

TEST(BallTracking, EstimatesPositionAndVelocityFromOneSee) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    Scene scene({-10.0, 5.0}, {0.8, -0.4}, side);
    scene.look();
    EXPECT_LT(scene.position_error(), 0.55);
    EXPECT_LT(scene.velocity_error(), 0.15);

    const BallState& ball = scene.world.ball;
    EXPECT_THAT(
        (std::array{ball.pos_count, ball.seen_pos_count, ball.relative_pos_count, ball.vel_count}),
        testing::Each(0));
    EXPECT_EQ(ball.heard_pos_count, kNever);
  }
}

TEST(BallTracking, ImprovesOverSeveralSees) {
  soccer::RandomStream random(1, "ball");
  double single = 0.0;
  double followed = 0.0;
  constexpr int kRolls = 40;

  for (int i = 0; i < kRolls; ++i) {
    Scene scene({});
    scene.truth.ball = {random.uniform(-10.0, 0.0), random.uniform(-8.0, 8.0)};
    scene.truth.ball_velocity =
        soccer::polar_degrees(random.uniform(0.5, 1.5), random.uniform(-180.0, 180.0));

    for (int cycle = 0; cycle < 8; ++cycle) {
      scene.look();
      if (cycle == 0) single += scene.position_error() / kRolls;
      if (cycle < 7) scene.roll(random);
    }
    followed += scene.position_error() / kRolls;
  }
  EXPECT_LT(single, 0.6);
  EXPECT_LT(followed, 0.5 * single);
}

TEST(BallTracking, PredictsUnseenBall) {
  Scene scene({-14.0, 3.0}, {1.0, 0.0});
  scene.look();
  const Vec2 seen = scene.world.ball.position;
  const Vec2 velocity = scene.world.ball.velocity;

  for (int i = 0; i < 3; ++i) {
    ++scene.truth.time;
    scene.sense();
  }

  const Vec2 expected = seen + velocity * (1.0 + 0.94 + 0.94 * 0.94);
  EXPECT_LT(soccer::distance(scene.world.ball.position, expected), 1e-9);
  EXPECT_LT(soccer::distance(scene.world.ball.position, ball_after(seen, velocity, 3, 0.94)), 1e-9);
  EXPECT_EQ(scene.world.ball.pos_count, 3);
  EXPECT_EQ(scene.world.ball.vel_count, 3);
  EXPECT_EQ(scene.world.ball.seen_position, seen);
}

TEST(BallTracking, PredictsOwnKick) {
  Scene scene({-19.4, 3.0});
  scene.look();
  update_derived(scene.world);
  ASSERT_TRUE(scene.world.self.kickable);

  record_sent_commands(scene.world, {soccer::Kick{50.0, 30.0}});
  ++scene.counts.kick;
  ++scene.truth.time;

  // docs/spec/simulation-model.md 4.4 with the ball straight ahead.
  const double gap = (0.6 - 0.3 - 0.085) / 0.7;
  const double speed = 50.0 * 0.027 * (1.0 - 0.25 * gap);
  const Vec2 expected = scene.truth.ball + soccer::polar_degrees(speed, 30.0);
  scene.sense();
  EXPECT_LT(soccer::distance(scene.world.ball.position, expected), 0.05);
  EXPECT_NEAR(scene.world.ball.velocity.length(), 0.94 * speed, 0.03);
  EXPECT_TRUE(scene.world.self.kicked);

  update_derived(scene.world);
  EXPECT_EQ(scene.world.last_kick.unum, 7);
  EXPECT_EQ(scene.world.last_kick.side, Side::kLeft);
}

TEST(BallTracking, DetectsOtherPlayersKickAtNextSee) {
  Scene scene({-8.0, 0.0});
  for (int i = 0; i < 4; ++i) {
    scene.look();
    ++scene.truth.time;
  }

  scene.truth.ball_velocity = {1.2, 1.4};
  scene.truth.ball += scene.truth.ball_velocity / 0.94;
  scene.look();
  EXPECT_LT(scene.position_error(), 0.6);
  EXPECT_LT(scene.velocity_error(), 0.25);
}

TEST(BallTracking, MarksMissingBallAsGhostAndThenInvalidatesIt) {
  Scene scene({-10.0, 3.0});
  scene.look();

  scene.truth.ball = {-40.0, -30.0};  // behind the observer
  ++scene.truth.time;
  scene.look();
  EXPECT_EQ(scene.world.ball.ghost_count, 1);
  EXPECT_TRUE(scene.world.ball.position_valid());

  ++scene.truth.time;
  scene.look();
  EXPECT_FALSE(scene.world.ball.position_valid());
  EXPECT_EQ(scene.world.ball.pos_count, kNever);
  EXPECT_EQ(scene.world.ball.seen_pos_count, 2);

  ++scene.truth.time;
  scene.sense();
  EXPECT_GE(scene.world.ball.lost_count, 2);
}

TEST(BallTracking, MarksNoGhostOutsideViewCone) {
  Scene scene({-10.0, 3.0});
  scene.look();
  scene.truth.self.neck = 90.0;
  scene.truth.self.body = 90.0;  // turned away from the ball
  for (int i = 0; i < 3; ++i) {
    ++scene.truth.time;
    scene.look();
  }
  EXPECT_EQ(scene.world.ball.ghost_count, 0);
  EXPECT_EQ(scene.world.ball.pos_count, 3);
}

TEST(BallTracking, MeasuresDistancePreciselyWithFocusPointOnBall) {
  soccer::RandomStream random(2, "focus");
  double plain = 0.0;
  double focused = 0.0;
  constexpr int kLooks = 100;

  for (int i = 0; i < kLooks; ++i) {
    Scene scene({});
    scene.truth.ball =
        scene.truth.self.position +
        soccer::polar_degrees(random.uniform(10.0, 30.0), random.uniform(-40.0, 40.0));
    scene.look();
    plain += scene.position_error() / kLooks;

    Scene again(scene.truth.ball);
    const Vec2 offset = again.truth.ball - again.truth.self.position;
    again.truth.focus_distance = offset.length() + random.uniform(-0.5, 0.5);
    again.truth.focus_direction = soccer::direction_degrees(offset);
    again.look();
    focused += again.position_error() / kLooks;
  }
  EXPECT_LT(focused, 0.25 * plain);
}

TEST(BallTracking, PlacesBallByRefereeMessages) {
  Scene scene({-10.0, 3.0}, {1.0, 1.0});
  scene.look();
  hear_referee(scene.world, 1, "kick_off_r");
  EXPECT_EQ(scene.world.ball.position, (Vec2{0.0, 0.0}));
  EXPECT_EQ(scene.world.ball.velocity, (Vec2{0.0, 0.0}));

  hear_referee(scene.world, 1, "corner_kick_l");
  EXPECT_NEAR(scene.world.ball.position.x, 51.5, 1e-9);

  hear_referee(scene.world, 1, "goal_kick_l");
  EXPECT_NEAR(scene.world.ball.position.x, -47.0, 1e-9);
  EXPECT_NEAR(std::fabs(scene.world.ball.position.y), 9.16, 1e-9);
}

}  // namespace
}  // namespace cls::player
