// Angles, shapes, sides, play modes, landmarks and channels in memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "soccer/angle.h"
#include "soccer/directions.h"
#include "soccer/geometry.h"
#include "soccer/interval.h"
#include "soccer/memory_channel.h"
#include "soccer/pitch.h"
#include "soccer/play_mode.h"
#include "soccer/random.h"
#include "soccer/side.h"

namespace cls::soccer {
namespace {

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

TEST(Angles, NormalizeToClosedRange) {
  EXPECT_EQ(math::normalize_degrees(190), -170);
  EXPECT_EQ(math::normalize_degrees(-190), 170);
  EXPECT_EQ(math::normalize_degrees(180), 180);
  EXPECT_EQ(math::normalize_degrees(-180), -180);
  EXPECT_EQ(math::normalize_degrees(725), 5);
  EXPECT_NEAR(math::normalize_radians(7 * math::kPi), math::kPi, 1e-12);
  EXPECT_EQ((AngleDeg(170) + AngleDeg(20)).degrees(), -170);
}

TEST(Angles, QuantizeRoundsHalfToEven) {
  EXPECT_EQ(math::quantize(0.25, 0.1), 0.2);
  EXPECT_DOUBLE_EQ(math::quantize(0.35, 0.1), 0.3);  // 0.35 / 0.1 is just below 3.5
  EXPECT_EQ(math::quantize(0.123, 0.0), 0.123);
}

TEST(Interval, HasItsEndsInEitherOrder) {
  for (const double value : {-30.0, -2.0, 0.0, 1.5, 3.0, 1e300}) {
    EXPECT_EQ(between(value, -2.0, 3.0), std::clamp(value, -2.0, 3.0));
    EXPECT_EQ(between(value, 3.0, -2.0), std::clamp(value, -2.0, 3.0));
  }
}

TEST(Directions, ArePairwiseTheSameBits) {
  const double values[] = {0.0, -0.0, 1e-9, -0.3, 1.0, -1.0, 52.5, -34.0, 1e300};

  for (const double y : values) {
    for (const double x : values) {
      const Vec2 a{x, y};
      const Vec2 b{-y, 0.7};
      const auto [first, second] = direction_pair(a, b);
      EXPECT_EQ(bits(first), bits(direction_degrees(a)));
      EXPECT_EQ(bits(second), bits(direction_degrees(b)));
    }
  }
}

TEST(Directions, OfManyVectorsAreTheSameBits) {
  RandomStream random(7, "directions");
  std::vector<Vec2> vectors = {{0.0, 0.0}, {-0.0, 0.0}, {-1.0, 0.0}, {-1.0, -0.0}, {0.0, -2.0}};

  while (vectors.size() < 997) {
    const double scale = math::exp(random.uniform(-40.0, 40.0));
    vectors.push_back({random.uniform(-1.0, 1.0) * scale, random.uniform(-1.0, 1.0)});
  }

  for (const std::size_t count : {0UL, 1UL, 2UL, 3UL, 4UL, 5UL, vectors.size()}) {
    std::vector<double> degrees(count + 1, 7.0);
    directions(vectors.data(), count, degrees.data());
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(bits(degrees[i]), bits(direction_degrees(vectors[i])));
    }
    EXPECT_EQ(degrees[count], 7.0);
  }
}

TEST(Directions, OfManyVectorsInRadiansAndBackAreTheSameBits) {
  RandomStream random(8, "directions");
  std::vector<Vec2> vectors = {{0.0, 0.0}, {-0.0, 0.0}, {-1.0, -0.0}};

  while (vectors.size() < 103) {
    vectors.push_back({random.uniform(-60.0, 60.0), random.uniform(-40.0, 40.0)});
  }

  for (const std::size_t count : {0UL, 3UL, 6UL, vectors.size()}) {
    std::vector<double> radians(count + 1, 7.0);
    directions_radians(vectors.data(), count, radians.data());
    std::vector<Vec2> units(count + 1, Vec2{7.0, 7.0});
    unit_vectors(radians.data(), count, units.data());
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(bits(radians[i]), bits(direction_radians(vectors[i])));
      EXPECT_EQ(units[i], polar_radians(1.0, radians[i]));
    }
    EXPECT_EQ(radians[count], 7.0);
    EXPECT_EQ(units[count], (Vec2{7.0, 7.0}));
  }
}

TEST(Shapes, NearestEdgePrefersHorizontalEdgeForEqualDistances) {
  const Rect rect = Rect::centered({0, 0}, 4, 2);
  EXPECT_EQ(nearest_edge(rect, {1.9, 0.2}), (Vec2{2.0, 0.2}));
  EXPECT_EQ(nearest_edge(rect, {1.5, 0.5}), (Vec2{1.5, 1.0}));
  EXPECT_EQ(nearest_horizontal_edge(rect, {5, 0}), (Vec2{2.0, 1.0}));
  EXPECT_TRUE(rect.contains({2, 1}));
  EXPECT_FALSE(rect.contains({2.0001, 1}));
}

TEST(Shapes, NearestEdgeOfCircleFromItsCenterIsDiagonal) {
  const Vec2 edge = nearest_edge(Circle{{1, 1}, 2}, {1, 1});
  EXPECT_DOUBLE_EQ(edge.x, edge.y);
  EXPECT_NEAR(nearest_edge(Circle{{0, 0}, 2}, {0, 0.5}).y, 2.0, 1e-12);
}

TEST(Shapes, DistanceToSegmentIsClampedToItsEnds) {
  const Segment segment{{0, 0}, {10, 0}};
  EXPECT_DOUBLE_EQ(distance(segment, {5, 3}), 3);
  EXPECT_DOUBLE_EQ(distance(segment, {13, 4}), 5);
}

TEST(Slots, NumberLeftPlayersBeforeRightPlayers) {
  EXPECT_EQ(slot_of(Side::kLeft, 1), 0);
  EXPECT_EQ(slot_of(Side::kRight, 11), 21);
  EXPECT_EQ(side_of_slot(10), Side::kLeft);
  EXPECT_EQ(unum_of_slot(11), 1);
  EXPECT_EQ(opponent(Side::kLeft), Side::kRight);
}

TEST(PlayModes, HaveNamesAndNumbersOfRcssserver) {
  EXPECT_EQ(name(PlayMode::kGoalKickLeft), "goal_kick_l");
  EXPECT_EQ(static_cast<int>(*parse_play_mode("indirect_free_kick_r")), 39);
  EXPECT_EQ(static_cast<int>(*parse_play_mode("illegal_defense_r")), 51);
  EXPECT_FALSE(parse_play_mode("half_time"));
  EXPECT_FALSE(parse_play_mode(""));
  for (int i = 1; i < kPlayModeCount; ++i) {
    EXPECT_EQ(parse_play_mode(name(static_cast<PlayMode>(i))), static_cast<PlayMode>(i));
  }
}

TEST(PlayModes, MapToSideAndToOtherVariant) {
  EXPECT_EQ(side(PlayMode::kGoalRight), Side::kRight);
  EXPECT_EQ(side(PlayMode::kPlayOn), Side::kNeutral);
  EXPECT_EQ(side(PlayMode::kDropBall), Side::kNeutral);
  EXPECT_EQ(for_side(PlayMode::kKickInLeft, Side::kRight), PlayMode::kKickInRight);
  EXPECT_EQ(for_side(PlayMode::kKickInRight, Side::kLeft), PlayMode::kKickInLeft);
  EXPECT_EQ(mode_class(PlayMode::kGoalLeft), ModeClass::kStopped);
  EXPECT_EQ(mode_class(PlayMode::kGoalKickLeft), ModeClass::kRunning);
  EXPECT_TRUE(is_set_play(PlayMode::kIndirectFreeKickRight));
  EXPECT_FALSE(is_set_play(PlayMode::kDropBall));
}

TEST(Landmarks, MatchRcssserver) {
  EXPECT_EQ(kLandmarks[9].name, "f g r t");
  EXPECT_EQ(kLandmarks[9].position, (Vec2{52.5, -7.01}));
  EXPECT_TRUE(kLandmarks[*landmark_index("g l")].is_goal());
  EXPECT_EQ(kLandmarks[*landmark_index("f b l 30")].position, (Vec2{-30, 39}));
  EXPECT_FALSE(landmark_index("f x"));
}

TEST(MemoryChannel, KnowsWhichEndReadsValues) {
  auto [server, client] = make_memory_channel();
  EXPECT_FALSE(server->peer_reads_values());
  EXPECT_TRUE(client->ask_for_values());
  EXPECT_TRUE(server->peer_reads_values());
  EXPECT_FALSE(client->peer_reads_values());
}

TEST(MemoryChannel, PreservesOrderAndDetectsClosedPeer) {
  auto [server, client] = make_memory_channel();
  EXPECT_TRUE(server->send("one"));
  EXPECT_TRUE(server->send("two"));

  std::string message;
  ASSERT_TRUE(client->receive(message));
  EXPECT_EQ(message, "one");
  ASSERT_TRUE(client->receive(message));
  EXPECT_EQ(message, "two");
  EXPECT_FALSE(client->receive(message));
  EXPECT_EQ(message, "two");
  EXPECT_FALSE(server->receive(message));

  server.reset();
  EXPECT_FALSE(client->send("three"));
}

}  // namespace
}  // namespace cls::soccer
