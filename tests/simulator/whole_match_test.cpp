// Whole matches of scripted teams: reproducible by seed, with all kinds of events.
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

TEST(WholeMatch, DependsOnSeedOnly) {
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

// The fingerprint changes only with the simulation; it is the same on every host.
TEST(WholeMatch, SeedSevenHasSameFingerprintOnEveryHost) {
  World world = full_match(short_match(), 7);
  Events events;
  for (int i = 0; i < 1500; ++i) play_cycle(world, events);
  EXPECT_EQ(fingerprint(world), 6451535778291104420ULL);
}

TEST(WholeMatch, CopyContinuesLikeOriginal) {
  World world = full_match(short_match(), 3);
  Events events;
  for (int i = 0; i < 700; ++i) play_cycle(world, events);
  World fork = world;
  for (int i = 0; i < 300; ++i) play_cycle(world, events);
  for (int i = 0; i < 300; ++i) play_cycle(fork, events);
  EXPECT_EQ(fingerprint(world), fingerprint(fork));
}

/// Invariants of every cycle.
void expect_sane(const World& world) {
  const soccer::ServerParams& server = world.params();
  ASSERT_TRUE(std::isfinite(world.ball.position.x) && std::isfinite(world.ball.position.y));
  ASSERT_LE(world.ball.velocity.length(), server.ball_speed_max * 1.05 * server.ball_decay + 1e-9);

  for (const Player& player : world.players) {
    ASSERT_TRUE(std::isfinite(player.position.x) && std::isfinite(player.position.y));
    // Some stoppages do not apply the field rule, and collisions are resolved after it.
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

TEST(WholeMatch, PlaysWholeMatchWithAllEvents) {
  std::map<std::string, int> calls;
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
      const auto* message = std::get_if<simulator::RefereeMessage>(&event.what);
      if (message == nullptr) continue;
      // Without the side suffix of mode names.
      std::string call(message->name);
      for (const char* side : {"_l", "_r"}) {
        if (const auto at = call.rfind(side); at != std::string::npos) call.resize(at);
      }
      ++calls[call];
    }
  }

  EXPECT_EQ(calls["half_time"], 10);
  EXPECT_EQ(calls["time_up"], 10);

  for (const char* call : {"goal", "kick_in", "corner_kick", "goal_kick", "free_kick", "offside",
                           "goalie_catch_ball", "foul_charge"}) {
    EXPECT_GT(calls[call], 0) << call;
  }
}

}  // namespace
}  // namespace cls::tests
