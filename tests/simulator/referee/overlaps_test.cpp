// Overlaps of players, against a plain loop over all pairs.
#include "simulator/referee/overlaps.h"

#include <gtest/gtest.h>

#include "soccer/random.h"
#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Bodies;
using simulator::BodySet;
using simulator::Overlaps;

// In a square so small that about one pair in ten overlaps.
Vec2 crowded_place(soccer::RandomStream& random) {
  return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
}

Overlaps plain_overlaps(const Bodies& bodies) {
  Overlaps pairs = {};
  for (std::size_t i = 0; i < bodies.count; ++i) {
    for (std::size_t k = i + 1; k < bodies.count; ++k) {
      const double radii = bodies.size[i] + bodies.size[k];
      const bool overlap = squared_distance(bodies.position(i), bodies.position(k)) < radii * radii;
      if (overlap) pairs[i] |= BodySet{1} << k;
    }
  }
  return pairs;
}

void add_crowd(Stage& stage, int players, soccer::RandomStream& random) {
  for (int i = 0; i < players; ++i) {
    stage.add(i % 2 == 0 ? Side::kLeft : Side::kRight, crowded_place(random));
  }
}

TEST(Overlaps, AreThoseOfAllPairsAfterAnyMove) {
  for (int players = 0; players <= soccer::kPlayersOnPitch; ++players) {
    soccer::RandomStream random(1, "crowd", static_cast<std::uint64_t>(players));
    Stage stage;
    add_crowd(stage, players, random);

    Bodies bodies;
    for (int round = 0; round < 50; ++round) {
      refresh(bodies, stage.world);
      ASSERT_EQ(bodies.count, static_cast<std::size_t>(players));
      ASSERT_EQ(find_overlaps(bodies), plain_overlaps(bodies)) << players << " in " << round;
      for (simulator::Player& player : stage.world.players) {
        if (player.enabled && random.bernoulli(0.3)) player.position = crowded_place(random);
      }
    }
  }
}

TEST(Overlaps, AreThoseOfAllPairsAfterPlayersLeave) {
  soccer::RandomStream random(2, "crowd");
  Stage stage;
  add_crowd(stage, soccer::kPlayersOnPitch, random);

  Bodies bodies;
  for (const simulator::Slot leaver : {4, 21, 0}) {
    stage.world.player(leaver).enabled = false;
    refresh(bodies, stage.world);
    EXPECT_EQ(find_overlaps(bodies), plain_overlaps(bodies)) << leaver;
  }
  EXPECT_EQ(bodies.count, 19U);
}

// Player types of one match may differ in size.
TEST(Overlaps, IsFoundWhenAPlayerGrowsInPlace) {
  Stage stage;
  simulator::Rules rules = *stage.world.rules;
  rules.types[1].player_size = 0.5;
  stage.world.rules = std::make_shared<const simulator::Rules>(std::move(rules));
  simulator::Player& player = stage.add(Side::kLeft, {0, 0});
  stage.add(Side::kRight, {0.7, 0});

  Bodies bodies;
  refresh(bodies, stage.world);
  EXPECT_EQ(find_overlaps(bodies)[0], 0U);

  player.type = 1;
  refresh(bodies, stage.world);
  EXPECT_EQ(find_overlaps(bodies)[0], 0b10U);
}

TEST(Overlaps, AreThoseOfAllPairsAfterBodiesMove) {
  soccer::RandomStream random(4, "crowd");
  Stage stage;

  add_crowd(stage, 15, random);
  Bodies bodies;
  refresh(bodies, stage.world);

  for (int round = 0; round < 50; ++round) {
    ASSERT_EQ(find_overlaps(bodies), plain_overlaps(bodies)) << round;
    for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
      const Vec2 place = crowded_place(random);
      if (random.bernoulli(0.7)) continue;
      move_body(bodies, slot, place);
      stage.world.player(slot).position = place;
    }
    const Bodies moved = bodies;
    refresh(bodies, stage.world);
    ASSERT_EQ(bodies.x, moved.x) << round;
    ASSERT_EQ(bodies.suspects, moved.suspects) << round;
  }
}

TEST(Overlaps, OfCircleAreThoseOfEachPlayer) {
  soccer::RandomStream random(3, "crowd");
  Stage stage;

  add_crowd(stage, 7, random);
  Bodies bodies;
  refresh(bodies, stage.world);

  for (int i = 0; i < 100; ++i) {
    const Vec2 center = crowded_place(random);
    BodySet expected = 0;
    for (std::size_t k = 0; k < bodies.count; ++k) {
      const double radii = 0.4 + bodies.size[k];
      if (squared_distance(center, bodies.position(k)) < radii * radii) expected |= BodySet{1} << k;
    }
    EXPECT_EQ(overlapping(bodies, center, 0.4), expected);
  }
}

}  // namespace
}  // namespace cls::tests
