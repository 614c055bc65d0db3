// see messages compared with rcssserver, and distributions of their noise.
#include "simulator/senses/vision.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/text/number_text.h"
#include "soccer/math.h"
#include "soccer/pitch.h"
#include "tests/simulator/senses/scene.h"

namespace cls::simulator {
namespace {

using testing::HasSubstr;

namespace math = soccer::math;

// Between 20 and 40 m it is random whether the motion of a flag is sent: some seed must reproduce
// the messages below.
testing::AssertionResult can_be_seen(const World& world, const Player& observer,
                                     const std::string& message) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    if (see_text(world, observer, seed) == message) return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "for example " << see_text(world, observer);
}

/// An observer of client version 18 on an empty pitch.
class Vision : public testing::Test {
 protected:
  World world = empty_pitch();
  Player& me = place(world, Side::kLeft, 1, {0, 0});
};

TEST_F(Vision, MatchesRcssserverForPlayerOnBench) {
  place(world, Side::kLeft, 1, {-3, -37}, 0, 19);
  EXPECT_TRUE(can_be_seen(
      world, me,
      "(see 0 ((f c t) 4.3 45 0 0) ((f r t) 55.7 3) ((f r b) 90 52) ((f g r b) 70.8 38) ((g r) "
      "66.7 34) ((f g r t) 62.8 28) ((f p r b) 69.4 56) ((f p r c) 53.5 43) ((f p r t) 42.5 23) "
      "((f t 0) 3.6 -34 0 0) ((f t r 10) 13.2 -9 0 0) ((f t r 20) 23.1 -5 0 0) ((f t r 30) 33.1 "
      "-3) ((f t r 40) 42.9 -3) ((f t r 50) 53 -2) ((f b r 50) 92.8 55) ((f r 0) 70.8 31) ((f r t "
      "10) 66 24) ((f r t 20) 62.8 16) ((f r t 30) 60.9 7) ((f r b 10) 76.7 38) ((f r b 20) 83.1 "
      "43) ((f r b 30) 90 48))"));
}

TEST_F(Vision, MatchesRcssserverForFocusedPlayer) {
  place(world, Side::kLeft, 1, {-3, -37}, 9.63341, 19);
  place(world, Side::kLeft, 2, {-6, -37}).goalie = true;
  place(world, Side::kRight, 1, {3, -37}, 0, 14);
  me.neck = math::to_radians(20);
  me.view.width = soccer::ViewWidth::kNarrow;

  EXPECT_TRUE(can_be_seen(
      world, me,
      "(see 0 ((f c t) 4.3 15 0 0) ((f r t) 55.7 -27) ((f r b) 90 22) ((f g r b) 70.8 9) ((g r) "
      "66.7 4) ((f g r t) 62.8 -1) ((f p r b) 69.4 26) ((f p r c) 53.5 14) ((f p r t) 42.5 -6) "
      "((f b r 50) 92.8 25) ((f r 0) 70.8 2) ((f r t 10) 66 -6) ((f r t 20) 62.8 -14) ((f r t 30) "
      "60.9 -23) ((f r b 10) 76.7 8) ((f r b 20) 83.1 14) ((f r b 30) 90 18) ((P) 3 150) ((p "
      "\"RightTeam\" 1) 6 -30 0 0 -30 -30) ((l r) 64.1 60) ((l t) 6 -30))"));

  me.view.focus_distance = 10;
  me.view.focus_direction = math::to_radians(20);

  EXPECT_TRUE(can_be_seen(
      world, me,
      "(see 0 ((f c t) 4.2 15 0 0) ((f r t) 55.7 -27) ((f r b) 89.9 22) ((f g r b) 70.8 9) ((g r) "
      "66.8 4) ((f g r t) 63 -1) ((f p r b) 69.2 26) ((f p r c) 53.6 14) ((f p r t) 42.5 -6) ((f "
      "b r 50) 92.9 25) ((f r 0) 70.9 2) ((f r t 10) 66.1 -6) ((f r t 20) 62.7 -14) ((f r t 30) "
      "60.9 -23) ((f r b 10) 76.6 8) ((f r b 20) 83 14) ((f r b 30) 90.3 18) ((P) 3 150) ((p "
      "\"RightTeam\" 1) 5.9 -30 0 0 -30 -30) ((l r) 64.1 60) ((l t) 6 -30))"));
}

TEST_F(Vision, MatchesRcssserverForOldClient) {
  me.enabled = false;
  Player& old = place(world, Side::kRight, 1, {3, -37}, 0, 14);
  old.view.focus_distance = 10;  // not used by this version
  EXPECT_TRUE(can_be_seen(
      world, old,
      "(see 0 ((f r t) 49.4 3) ((f g r b) 66 42) ((g r) 61.6 37) ((f g r t) 58 31) ((f p r t) 37 "
      "27) ((f t r 10) 7.3 -16 0 0) ((f t r 20) 17.1 -7 0 0) ((f t r 30) 27.1 -4 0 0) ((f t r 40) "
      "37 -3) ((f t r 50) 47 -2) ((f r 0) 66 34) ((f r t 10) 60.9 26) ((f r t 20) 56.8 17) ((f r t "
      "30) 55.1 7) ((f r b 10) 72.2 41))"));
}

TEST_F(Vision, ReportsOnlyDirectionsInLowQuality) {
  place(world, Side::kLeft, 1, {-3, -37}, 9.63341, 15);
  place(world, Side::kLeft, 2, {-6, -37});
  place(world, Side::kRight, 1, {3, -37});
  me.view.quality = soccer::ViewQuality::kLow;
  const std::string see = see_text(world, me);
  EXPECT_EQ(see_part(see, "(f c t)"), "((f c t) 35)");
  EXPECT_EQ(see_part(see, "(p \"RightTeam\" 1)"), "((p \"RightTeam\" 1) -10)");
  EXPECT_EQ(see_part(see, "(P)"), "((P) 170)");
  EXPECT_EQ(see_part(see, "(l r)"), "((l r) 80)");
}

TEST_F(Vision, QuantizesMotion) {
  me.velocity = {0.2, 0};
  world.ball.position = {10, 0};
  world.ball.velocity = {-1, 0.5};
  // -1.2 / 10 = -0.12 of 10 m a cycle; 0.5 / 10 rad = 2.86 degrees a cycle.
  EXPECT_EQ(see_part(see_text(world, me), "(b)"), "((b) 10 0 -1.2 2.9)");
}

// Includes directions next to a rounding boundary or to the edge of the view cone.
TEST_F(Vision, RoundsExactDirections) {
  const VisionModel model(world.params());
  RandomStream random(1, "places");
  RandomStream noise(1, "noise");
  soccer::See seen;
  int count = 0;

  for (int i = 0; i < 4000; ++i) {
    me.position = {random.uniform(-60.0, 60.0), random.uniform(-40.0, 40.0)};
    me.body = random.uniform(-math::kPi, math::kPi);
    me.neck = random.uniform(-1.5, 1.5);
    const auto direction_to = [&](std::size_t landmark) {
      const Vec2 offset = soccer::kLandmarks[landmark].position - me.position;
      return math::normalize_radians(
          math::normalize_radians(soccer::direction_radians(offset) - me.body) - me.neck);
    };
    if (i % 2 == 0) {
      const double to_border =
          direction_to(static_cast<std::size_t>(i) % soccer::kLandmarks.size()) -
          math::to_radians(i % 90 + 0.5) + random.uniform(-4e-5, 4e-5);
      me.body = math::normalize_radians(me.body + to_border);
    }
    see(model, world, me.slot(), noise, seen);
    for (const soccer::Observation& object : seen.objects) {
      if (object.kind != soccer::ObservedKind::kLandmark) continue;
      ++count;
      ASSERT_EQ(object.direction, std::rint(math::to_degrees(direction_to(object.index))));
    }
  }

  EXPECT_GT(count, 50000);
}

TEST_F(Vision, CoversViewConeAndThreeMetersAround) {
  const auto ball_at = [&](double degrees, double distance) {
    world.ball.position = soccer::polar_degrees(distance, degrees);
    return see_text(world, me);
  };
  EXPECT_NE(see_part(ball_at(59.9, 10), "(b)"), "");
  EXPECT_EQ(see_part(ball_at(60.1, 10), "(b)"), "");
  EXPECT_EQ(see_part(ball_at(-179, 2.9), "(B)"), "((B) 3 -179)");
  EXPECT_EQ(see_part(ball_at(-179, 3.1), "(B)"), "");
  me.view.width = soccer::ViewWidth::kWide;
  EXPECT_NE(see_part(ball_at(89.9, 10), "(b)"), "");
  EXPECT_EQ(see_part(ball_at(90.1, 10), "(b)"), "");
}

TEST_F(Vision, IdentifiesPlayersByDistance) {
  place(world, Side::kLeft, 1, {-50, 0});
  Player& other = place(world, Side::kRight, 7, {-31, 0}, 90);
  other.goalie = true;
  EXPECT_EQ(see_part(see_text(world, me), "(p"), "((p \"RightTeam\" 7 goalie)");

  const auto shares = [&](double x, std::string_view name) {
    other.position.x = x;
    int count = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
      count += see_text(world, me, seed).find(name) != std::string::npos;
    }
    return count / 2000.0;
  };

  // 30 m is quantized to 30: half of the messages lack the uniform number. 4 deviations: 0.045.
  EXPECT_NEAR(shares(-20, "(p \"RightTeam\" 7"), 0.5, 0.045);
  EXPECT_EQ(shares(-20, "(p \"RightTeam\""), 1.0);
  EXPECT_EQ(shares(-8, "(p \"RightTeam\" 7"), 0.0);

  me.client_version = 17;
  me.view.synchronous = true;
  EXPECT_NEAR(shares(0, "((p)"), 0.495, 0.045);  // 50 m is quantized to 49.9
  EXPECT_EQ(shares(12, "((p)"), 1.0);
}

TEST_F(Vision, ShowsFixedNameOfOpponents) {
  soccer::ServerParams params;
  params.fixed_teamname_l = "Home";
  params.fixed_teamname_r = "Away";
  world = empty_pitch(params);
  place(world, Side::kLeft, 1, {0, 0});
  place(world, Side::kLeft, 2, {5, 0});
  place(world, Side::kRight, 3, {6, 0});
  const std::string see = see_text(world, me);
  EXPECT_THAT(see, HasSubstr("(p \"LeftTeam\" 2)"));
  EXPECT_THAT(see, HasSubstr("(p \"Away\" 3)"));
}

TEST_F(Vision, MarksKickersAndTacklers) {
  Player& other = place(world, Side::kRight, 7, {8, 0}, 180);
  other.kick_cycles = 0;
  const std::string name = "(p \"RightTeam\" 7)";
  EXPECT_EQ(see_part(see_text(world, me), name), "((p \"RightTeam\" 7) 8.2 0 0 0 180 180 k)");
  other.tackle_cycles = 9;
  EXPECT_EQ(see_part(see_text(world, me), name), "((p \"RightTeam\" 7) 8.2 0 0 0 180 180 t)");
  other.tackle_cycles = 0;
  other.kick_cycles = -1;
  EXPECT_EQ(see_part(see_text(world, me), name), "((p \"RightTeam\" 7) 8.2 0 0 0 180 180)");
}

TEST_F(Vision, PointingNoiseGrowsWithDistance) {
  place(world, Side::kLeft, 1, {-10, 0});
  Player& other = place(world, Side::kRight, 7, {0, 0});
  other.arm = {{10, 10}, 3};  // 45 degrees from there
  const int count = 4000;
  double sum = 0.0;
  double square = 0.0;

  for (std::uint64_t seed = 0; seed < count; ++seed) {
    RandomStream noise(seed, "test");
    soccer::See message;
    see(VisionModel(world.params()), world, me.slot(), noise, message);
    for (const soccer::Observation& object : message.objects) {
      if (object.kind != soccer::ObservedKind::kPlayer) continue;
      ASSERT_TRUE(object.pointing);
      sum += object.point_direction - 45.0;
      square += (object.point_direction - 45.0) * (object.point_direction - 45.0);
    }
  }

  // (10 / 125.1)^4 * 178.75 + 1.25 degrees, plus rounding to whole degrees.
  const double deviation = std::sqrt(1.2573 * 1.2573 + 1.0 / 12.0);

  EXPECT_NEAR(sum / count, 0.0, 4 * deviation / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(square / count), deviation, 4 * deviation / std::sqrt(2.0 * count));
}

TEST_F(Vision, GaussianNoiseIsCenteredOnExactDistance) {
  place(world, Side::kLeft, 1, {0, 0}, 0, 19);
  me.view.gaussian = true;
  me.view.focus_distance = 30;
  world.ball.position = {20, 0};  // 20 m away, 10 m from the focus
  const int count = 4000;
  double sum = 0.0;
  double square = 0.0;

  for (std::uint64_t seed = 0; seed < count; ++seed) {
    double distance = 0.0;
    base::parse_number_prefix(see_part(see_text(world, me, seed), "(b)").substr(5), distance);
    const double error = distance - 20.0;
    sum += error;
    square += error * error;
  }
  const double deviation = 20 * 0.0125 + 10 * 0.0125;

  EXPECT_NEAR(sum / count, 0.0, 4 * deviation / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(square / count), deviation, 4 * deviation / std::sqrt(2.0 * count));
}

TEST(DistanceQuantizer, TableMatchesComputation) {
  const DistanceQuantizer steps(0.1);
  for (const double distance : {0.0, 1e-6, 0.049, 0.05, 0.3, 1.0, 17.3, 125.0, 249.0, 260.0, 1e4}) {
    const double expected = math::exp(std::rint(math::log(distance + 1e-10) / 0.1) * 0.1);
    EXPECT_EQ(steps(distance), expected) << distance;
  }
  EXPECT_NEAR(DistanceQuantizer(0.0)(17.3), 17.3, 1e-9);
}

// Around every edge between two values, and at random distances.
TEST(DistanceQuantizer, TableMatchesComputationAtEveryEdge) {
  for (const double step : {0.5, 0.1, 0.01, 0.002}) {
    const DistanceQuantizer steps(step);
    const auto expect_computed = [&](double distance) {
      const double multiple = std::rint(math::log(distance + 1e-10) / step);
      ASSERT_EQ(steps(distance), math::exp(multiple * step)) << distance << " in steps of " << step;
    };
    for (double k = math::log(0.04) / step; k * step < math::log(300.0); k += 0.25) {
      const double near = math::exp((std::floor(k) + 0.5) * step) - 1e-10;
      for (const double off : {0.0, 1e-16, 1e-14, 1e-12, 1e-11, 1e-9}) {
        expect_computed(near * (1.0 + off));
        expect_computed(near * (1.0 - off));
      }
      expect_computed(math::exp(k * step));
    }
  }
}

}  // namespace
}  // namespace cls::simulator
