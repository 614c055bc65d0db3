// Motion against values computed by hand from docs/spec/simulation-model.md.
#include "player/world/motion.h"

#include <gtest/gtest.h>

#include <utility>

#include "player/perception/perception.h"
#include "tests/support/known_pitch.h"

namespace cls::player {
namespace {

using tests::KnownPitch;

TEST(Motion, DashRateDecreasesToSideAndIncreasesToBack) {
  const soccer::ServerParams server;
  for (const auto& [direction, rate] : {std::pair{0.0, 1.0},
                                        {45.0, 0.7},
                                        {-90.0, 0.4},
                                        {135.0, 0.55},
                                        {180.0, 0.7},
                                        {540.0, 0.7}}) {
    EXPECT_DOUBLE_EQ(dash_rate(server, direction), rate) << direction;
  }
}

TEST(Motion, DashAccelerationUsesPowerRateAndEffort) {
  KnownPitch pitch;
  pitch.place_self({}, 90.0);
  pitch.world.self.effort = 0.8;
  const Vec2 ahead = dash_acceleration(pitch.world, 100.0, 0.0);
  EXPECT_NEAR(ahead.x, 0.0, 1e-12);
  EXPECT_NEAR(ahead.y, 0.8 * 100.0 * 0.006, 1e-12);
  const Vec2 back = dash_acceleration(pitch.world, 100.0, 180.0);
  EXPECT_NEAR(back.y, -0.8 * 100.0 * 0.006 * 0.7, 1e-12);
}

TEST(Motion, TurnResistanceGrowsWithSpeed) {
  const soccer::PlayerType type;
  EXPECT_DOUBLE_EQ(turn_resistance(type, {}), 1.0);
  EXPECT_DOUBLE_EQ(turn_resistance(type, {0.3, 0.4}), 3.5);
}

TEST(Motion, CoastingIsGeometricSeries) {
  // 1 + 0.94 + 0.8836
  EXPECT_NEAR(coast({}, {1.0, 0.0}, 0.94, 3).x, 2.8236, 1e-12);
  EXPECT_NEAR(coast({}, {1.0, 0.0}, 0.94, 0).x, 0.0, 1e-12);
  EXPECT_NEAR(rest_point({}, {0.6, 0.0}, 0.4).x, 1.0, 1e-12);
  EXPECT_NEAR(first_speed(2.8236, 3, 0.94), 1.0, 1e-12);
  EXPECT_NEAR(power_of(0.5, 10), 1.0 / 1024.0, 1e-15);
}

TEST(Motion, CyclesToRunFollowModel) {
  // Default type from rest: 0.6, then 0.6 * 0.4 + 0.6 = 0.84, then 0.936: 0.6, 1.44, 2.376.
  const soccer::ServerParams server;
  const soccer::PlayerType type;
  for (const auto& [distance, cycles] :
       {std::pair{-1.0, 0}, {0.59, 1}, {0.61, 2}, {1.45, 3}, {2.38, 4}}) {
    EXPECT_EQ(cycles_to_run(server, type, distance), cycles);
  }
  // Constant 1 meter per cycle after losing 2/3 meter.
  EXPECT_EQ(cycles_to_run(server, type, 50.0), 51);

  soccer::ServerParams stuck = server;
  stuck.max_dash_power = 0.0;
  EXPECT_GE(cycles_to_run(stuck, type, 10.0), 1'000'000);
}

TEST(Motion, FullRunsFollowModelAndAnnouncedTypes) {
  WorldModel world;
  soccer::PlayerType quick;
  quick.id = 2;
  quick.player_decay = 0.5;
  on_player_type(world, quick);
  soccer::ServerParams weak;
  weak.max_dash_power = 50.0;
  on_server_param(world, weak);

  // The default type by the numbers above with half the power, also for ids without a type.
  for (const int id : {0, -1, 7}) {
    const FullRun& run = world.parameters->full_run(id);
    EXPECT_NEAR(run.distance[1], 0.3, 1e-12);
    EXPECT_NEAR(run.distance[3], 1.188, 1e-12);
    EXPECT_NEAR(run.top_speed, 0.5, 1e-12);
    EXPECT_NEAR(run.drift[3], 1.56, 1e-12);  // 1 + 0.4 + 0.16
  }

  EXPECT_NEAR(world.parameters->full_run(2).distance[2], 0.3 + 0.45, 1e-12);
}

TEST(Motion, KickRateDecreasesWithDistanceAndAngle) {
  KnownPitch pitch;
  EXPECT_NEAR(kick_rate(pitch.world, {0.385, 0.0}, {}), 0.027, 1e-12);
  EXPECT_NEAR(kick_rate(pitch.world, {1.085, 0.0}, {}), 0.027 * 0.75, 1e-12);
  EXPECT_NEAR(kick_rate(pitch.world, {-1.085, 0.0}, {}), 0.027 * 0.5, 1e-12);
  EXPECT_NEAR(kick_rate(pitch.world, {0.0, 0.735}, {}), 0.027 * 0.75, 1e-12);
}

TEST(Motion, SafeDashPowerPreservesRecovery) {
  KnownPitch pitch;
  pitch.world.self.stamina = 0.3 * 8000.0 + 31.0;
  EXPECT_NEAR(safe_dash_power(pitch.world, 100.0), 30.0, 1e-9);
  EXPECT_NEAR(safe_dash_power(pitch.world, 20.0), 20.0, 1e-9);
  pitch.world.self.stamina = 1000.0;
  EXPECT_EQ(safe_dash_power(pitch.world, 100.0), 0.0);
  pitch.world.self.capacity = 0.0;
  pitch.world.self.stamina = 10.0;
  EXPECT_NEAR(safe_dash_power(pitch.world, 100.0), 60.0, 1e-9);
}

}  // namespace
}  // namespace cls::player
