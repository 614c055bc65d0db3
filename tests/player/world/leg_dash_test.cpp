// Two-leg dashes: the prediction against the simulator, and where agents use them.
#include "player/world/leg_dash.h"

#include <gtest/gtest.h>

#include <cmath>

#include "player/commands/command_slots.h"
#include "player/movement/movement.h"
#include "player/perception/perception.h"
#include "player/world/motion.h"
#include "soccer/random.h"
#include "tests/simulator/stage.h"
#include "tests/support/known_pitch.h"

namespace cls::player {
namespace {

using soccer::Dash;
using soccer::LegDash;
using tests::KnownPitch;

/// The world model of a player of the stage, which knows its state exactly.
WorldModel model_of(const tests::Stage& stage, const simulator::Player& player) {
  WorldModel world;
  auto parameters = std::make_shared<MatchParameters>();
  parameters->server = stage.world.params();
  parameters->types = stage.world.rules->types;
  world.parameters = parameters;
  world.our_side = Side::kLeft;
  world.unum = 1;
  world.leg_dashes = true;

  SelfState& self = world.self;
  self.type_id = player.type;
  self.position = player.position;
  self.velocity = player.velocity;
  self.body = AngleDeg(math::to_degrees(player.body));
  self.stamina = player.stamina.value;
  self.effort = player.stamina.effort;
  self.recovery = player.stamina.recovery;
  self.capacity = player.stamina.capacity;

  return world;
}

LegDash random_legs(soccer::RandomStream& random) {
  const auto leg = [&]() -> std::optional<Dash> {
    if (random.bernoulli(0.1)) return std::nullopt;
    return Dash{random.uniform(-20.0, 130.0), random.uniform(-200.0, 200.0)};
  };
  LegDash legs{leg(), leg()};
  if (!legs.left && !legs.right) legs.left = Dash{50.0, 10.0};
  return legs;
}

// Radians in the simulator, degrees in the world model: equal to rounding.
constexpr double kRounding = 1e-11;

TEST(LegDash, PredictionEqualsSimulator) {
  soccer::RandomStream random(3, "legs");
  tests::Stage stage;
  simulator::Player& player = stage.add(Side::kLeft, {});
  stage.place_ball({-30.0, 20.0});

  for (int i = 0; i < 2000; ++i) {
    stage.place(player, {random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0)},
                soccer::polar_degrees(random.uniform(0.0, 0.4), random.uniform(-180.0, 180.0)));
    player.body = player.pending_body = math::to_radians(random.uniform(-180.0, 180.0));
    player.stamina.effort = random.uniform(0.6, 1.0);
    // In a third of the cases stamina is short.
    player.stamina.value = random.bernoulli(0.33) ? random.uniform(0.0, 60.0) : 5000.0;
    player.stamina.recovery = 1.0;
    const WorldModel world = model_of(stage, player);
    const LegDash legs = random_legs(random);
    const DashEffect effect = leg_dash_effect(world, world.self.body, legs);

    const Vec2 velocity = player.velocity;
    const Vec2 position = player.position;
    const double stamina = player.stamina.value;
    const auto& type = stage.world.type_of(player);
    simulator::apply(stage.world, player.slot(), legs, stage.events);
    stage.step();

    const Vec2 moved = speed_limited(velocity + effect.acceleration, type.player_speed_max);
    tests::expect_near(player.position, position + moved, kRounding);
    const double body = (AngleDeg(math::to_degrees(player.body)) - world.self.body).degrees();
    EXPECT_NEAR(math::normalize_degrees(body - effect.turn), 0.0, 1e-9);
    EXPECT_LE(effect.cost, stamina + type.extra_stamina);
    if (stamina > 1000.0) {
      // Full recovery in the same step.
      const double spent = stamina - player.stamina.value + type.stamina_inc_max;
      EXPECT_NEAR(effect.cost, spent, 1e-9);
    }
  }
}

TEST(LegDash, SlotsSendWhatTheyPredict) {
  soccer::RandomStream random(4, "slots");
  tests::Stage stage;
  simulator::Player& player = stage.add(Side::kLeft, {});
  stage.place_ball({-30.0, 20.0});

  for (int i = 0; i < 300; ++i) {
    stage.place(player, {}, soccer::polar_degrees(0.3, random.uniform(-180.0, 180.0)));
    player.stamina.value = random.bernoulli(0.3) ? random.uniform(0.0, 40.0) : 4000.0;
    const WorldModel world = model_of(stage, player);
    CommandSlots slots(world);
    ASSERT_TRUE(slots.dash(random_legs(random)));

    std::vector<soccer::PlayerCommand> commands;
    slots.compose(commands);
    for (const auto& command : commands) {
      std::string text;
      EXPECT_TRUE(soccer::format(command, text));
      simulator::apply(stage.world, player.slot(), command, stage.events);
    }

    const Vec2 expected = slots.next_position();
    const AngleDeg body = slots.next_body();
    stage.step();
    tests::expect_near(player.position, expected, kRounding);
    EXPECT_NEAR((AngleDeg(math::to_degrees(player.body)) - body).degrees(), 0.0, 1e-9);
  }
}

TEST(LegDash, SlotsRejectWhatIsNotFinite) {
  const KnownPitch pitch;
  CommandSlots slots(pitch.world);
  EXPECT_FALSE(slots.dash(LegDash{}));
  EXPECT_FALSE(slots.dash(LegDash{Dash{std::nan(""), 0.0}, Dash{10.0, 0.0}}));
  EXPECT_FALSE(slots.dash(LegDash{Dash{10.0, 0.0}, Dash{10.0, INFINITY}}));
  EXPECT_FALSE(slots.has_body());
}

TEST(LegTurn, TurnsByTheAngleAndGainsMoreThanStraightLegs) {
  KnownPitch pitch;
  for (int angle = -95; angle <= 95; angle += 5) {
    pitch.place_self({}, 20.0, {0.3, 0.2});
    const auto turn = leg_turn(pitch.world, angle, 100.0);
    ASSERT_TRUE(turn.has_value()) << angle;

    const DashEffect effect = leg_dash_effect(pitch.world, pitch.world.self.body, turn->legs);
    EXPECT_NEAR(effect.turn, angle, 1e-3) << "powers have three decimals";
    tests::expect_near(turn->acceleration, effect.acceleration, 1e-5);
    EXPECT_NEAR(turn->cost, effect.cost, 1e-3);
    EXPECT_LE(turn->cost, 100.0);
    const Vec2 heading = soccer::polar_degrees(1.0, 20.0 + angle);
    EXPECT_NEAR(dot(turn->acceleration, heading), turn->progress, 1e-9);

    // Both legs along the body: the outer one full, the inner one forward or backward.
    const double difference = 0.6 * math::to_radians(std::abs(angle));
    const double straight = 0.5 * (0.6 + 0.6 - difference) * math::cos(math::to_radians(angle));
    EXPECT_GE(turn->progress, straight - 1e-6) << angle;
  }
  EXPECT_FALSE(leg_turn(pitch.world, 110.0, 100.0).has_value());
}

TEST(LegTurn, ObeysThePowerLimit) {
  KnownPitch pitch;
  for (const double power : {45.0, 60.0, 80.0}) {
    const auto turn = leg_turn(pitch.world, 20.0, power);
    ASSERT_TRUE(turn.has_value());
    EXPECT_LE(turn->cost, power + 1e-9);
    EXPECT_NEAR(leg_dash_effect(pitch.world, {}, turn->legs).turn, 20.0, 1e-3);
  }
  EXPECT_FALSE(leg_turn(pitch.world, 20.0, 5.0).has_value());
}

TEST(LegTurn, IsUsedOnlyByAgentsWithTwoLegs) {
  KnownPitch pitch;
  EXPECT_FALSE(useful_leg_turn(pitch.world, 40.0, 100.0, true).has_value());

  pitch.world.leg_dashes = true;
  EXPECT_TRUE(useful_leg_turn(pitch.world, 40.0, 100.0, true).has_value());
  EXPECT_FALSE(useful_leg_turn(pitch.world, 0.5, 100.0, true).has_value());
  EXPECT_TRUE(useful_leg_turn(pitch.world, 30.0, 100.0, false).has_value());
  EXPECT_FALSE(useful_leg_turn(pitch.world, 70.0, 100.0, false).has_value()) << "wastes stamina";
}

/// Cycles until the agent is at a target 15 m away.
int cycles_to_go(bool leg_dashes, double body, Vec2 velocity) {
  KnownPitch pitch;
  pitch.world.leg_dashes = leg_dashes;
  pitch.place_self({}, body, velocity);
  const Vec2 target{15.0, 0.0};
  return pitch.act_until(
      60,
      [&](protos::PlayerActions& reply) {
        auto& go = *reply.add_actions()->mutable_body_go_to_point();
        go.mutable_target_point()->set_x(15.0F);
        go.set_distance_threshold(0.5F);
        go.set_max_dash_power(100.0F);
      },
      [&] { return distance(pitch.world.self.position, target) < 1.0; });
}

TEST(LegTurn, ReachesPointsSooner) {
  int with = 0;
  int without = 0;
  for (int body = -180; body < 180; body += 15) {
    for (const double speed : {0.0, 0.2, 0.4}) {
      const Vec2 velocity = soccer::polar_degrees(speed, body);
      const int two_legs = cycles_to_go(true, body, velocity);
      const int plain = cycles_to_go(false, body, velocity);
      EXPECT_LE(two_legs, plain + 1) << body << ' ' << speed;
      with += two_legs;
      without += plain;
    }
  }
  // 72 runs: most of those that need a turn save a part of a cycle.
  EXPECT_LT(with, without - 24);
}

TEST(LegTurn, InterceptsSooner) {
  int with = 0;
  int without = 0;
  for (int body = -90; body <= 90; body += 15) {
    for (const bool leg_dashes : {true, false}) {
      KnownPitch pitch;
      pitch.world.leg_dashes = leg_dashes;
      pitch.place_self({}, body, soccer::polar_degrees(0.4, body));
      pitch.place_ball({10.0, -3.0}, {0.3, 0.3});
      const int planned = pitch.world.intercept.best_self_steps();
      const int cycles = pitch.act_until(
          60, [](protos::PlayerActions& reply) { reply.add_actions()->mutable_body_intercept(); },
          [&] { return pitch.world.self.kickable; });
      EXPECT_LE(cycles, planned + 1) << body;
      (leg_dashes ? with : without) += cycles;
    }
  }
  EXPECT_LT(with, without - 4);
}

}  // namespace
}  // namespace cls::player
