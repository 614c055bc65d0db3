// Whole matches between scripted teams: the same seed is the same match, and nothing gets lost.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "simulator/step.h"
#include "tests/simulator/scripted_match.h"
#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Events;
using simulator::Player;
using simulator::World;

soccer::ServerParams short_match() {
  soccer::ServerParams server;
  server.half_time = 60;
  server.nr_extra_halfs = 0;
  server.penalty_shoot_outs = false;
  return server;
}

TEST(WholeMatch, TheSameSeedIsTheSameMatchAndAnotherIsNot) {
  World first = full_match(short_match(), 7);
  World second = full_match(short_match(), 7);
  World other = full_match(short_match(), 8);
  Events events;
  for (int i = 0; i < 1500; ++i) {
    for (World* world : {&first, &second, &other}) play_cycle(*world, events);
    events.clear();
    ASSERT_EQ(fingerprint(first), fingerprint(second)) << "cycle " << i;
  }
  EXPECT_NE(fingerprint(first), fingerprint(other));
}

// The figure changes only when the game does; on any other machine it must be the same.
TEST(WholeMatch, SeedSevenIsThisMatchOnEveryMachine) {
  World world = full_match(short_match(), 7);
  Events events;
  for (int i = 0; i < 1500; ++i) play_cycle(world, events);
  EXPECT_EQ(fingerprint(world), 6451535778291104420ULL);
}

TEST(WholeMatch, ACopyGoesOnLikeTheOriginal) {
  World world = full_match(short_match(), 3);
  Events events;
  for (int i = 0; i < 700; ++i) play_cycle(world, events);
  World fork = world;
  for (int i = 0; i < 300; ++i) play_cycle(world, events);
  for (int i = 0; i < 300; ++i) play_cycle(fork, events);
  EXPECT_EQ(fingerprint(world), fingerprint(fork));
}

/// What is true in every cycle of every match.
void expect_sane(const World& world) {
  const soccer::ServerParams& server = world.params();
  ASSERT_TRUE(std::isfinite(world.ball.position.x) && std::isfinite(world.ball.position.y));
  ASSERT_LE(world.ball.velocity.length(), server.ball_speed_max * 1.05 * server.ball_decay + 1e-9);
  for (const Player& player : world.players) {
    ASSERT_TRUE(std::isfinite(player.position.x) && std::isfinite(player.position.y));
    // Some pauses go without the rule about the field; and collisions come after it.
    if (world.mode == PlayMode::kPlayOn) {
      ASSERT_LE(std::fabs(player.position.x), 57.5 + 1.0);
      ASSERT_LE(std::fabs(player.position.y), 39.0 + 1.0);
    }
    ASSERT_GE(player.stamina.value, 0.0);
    ASSERT_LE(player.stamina.value, server.stamina_max);
    ASSERT_GE(player.stamina.capacity, 0.0);
    ASSERT_LE(std::fabs(player.body), soccer::math::kPi);
  }
}

TEST(WholeMatch, EverythingHappensAndEndsInTime) {
  std::map<std::string, int> words;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    World world = full_match(short_match(), seed);
    Events events;
    int cycles = 0;
    while (world.mode != PlayMode::kTimeOver && cycles < 4000) {
      play_cycle(world, events);
      ++cycles;
      ASSERT_NO_FATAL_FAILURE(expect_sane(world)) << "seed " << seed << " cycle " << cycles;
    }
    EXPECT_EQ(world.clock.time, 1200);
    for (const auto& event : events) {
      const auto* said = std::get_if<simulator::RefereeSaid>(&event.what);
      if (said == nullptr) continue;
      // Without the side that modes have in their names.
      std::string word(said->word);
      for (const char* side : {"_l", "_r"}) {
        if (const auto at = word.rfind(side); at != std::string::npos) word.resize(at);
      }
      ++words[word];
    }
  }
  EXPECT_EQ(words["half_time"], 10);
  EXPECT_EQ(words["time_up"], 10);
  for (const char* word : {"goal", "kick_in", "corner_kick", "goal_kick", "free_kick", "offside",
                           "goalie_catch_ball", "foul_charge"}) {
    EXPECT_GT(words[word], 0) << word;
  }
}

}  // namespace
}  // namespace cls::tests
