// The full state of an episode as numbers: ball, clock and all players of the cast.
#include <algorithm>

#include "soccer/per_side.h"
#include "soccer/pitch.h"
#include "training/episode/setup.h"
#include "training/features/feature_writer.h"
#include "training/features/mode_columns.h"

namespace cls::training {
namespace {

constexpr double kPlayerSpeed = 1.2;
constexpr double kBallSpeed = 3.0;
constexpr int kPlayerColumns = 8;

void add_player(const simulator::World& world, int slot, FeatureWriter& out) {
  const simulator::Player& player = world.player(slot);
  out.flag(player.enabled);
  if (!player.enabled) return out.same(kPlayerColumns - 1, 0.0F);
  out.value(player.position.x / soccer::kHalfLength, -1.2, 1.2);
  out.value(player.position.y / soccer::kHalfWidth, -1.2, 1.2);
  out.value(player.velocity.x / kPlayerSpeed);
  out.value(player.velocity.y / kPlayerSpeed);
  out.angle(player.body);
  out.value(player.stamina.value / world.params().stamina_max, 0.0);
}

// What of a player decides the future besides, in version 2.
void append_condition(Columns& out, const std::string& name) {
  append(out, name, {"_effort", "_recovery", "_capacity"}, "1", 0);
  append(out, name, {"_neck_sin", "_neck_cos"});
  append(out, name, {"_tackle_cycles", "_foul_cycles", "_catch_ban"}, "10 cycles", 0);
  append(out, name, {"_cards"}, "2", 0);
  append(out, name, {"_arm_age"}, "20 cycles", 0);
  append(out, name, {"_kickable_area"}, "2 m", 0);
  append(out, name, {"_speed_max"}, "1.2 m/cycle", 0);
  append(out, name, {"_decay"}, "1", 0);
  append(out, name, {"_touched_last"}, "0/1");
}

constexpr int kConditionColumns = 14;

void add_condition(const simulator::World& world, int slot, FeatureWriter& out) {
  const simulator::Player& player = world.player(slot);
  if (!player.enabled) return out.same(kConditionColumns, 0.0F);
  const double capacity = world.params().stamina_capacity;
  out.value(player.stamina.effort, 0.0);
  out.value(player.stamina.recovery, 0.0);
  out.value(capacity < 0.0 ? 1.0 : player.stamina.capacity / capacity, 0.0);
  out.angle(player.neck);
  for (const int cycles : {player.tackle_cycles, player.foul_cycles, player.catch_ban}) {
    out.value(cycles / 10.0, 0.0);
  }

  out.value(player.cards / 2.0, 0.0);
  out.value(player.arm.age / 20.0, 0.0);
  const soccer::PlayerType& type = world.type_of(player);
  out.value(type.kickable_area(world.params().ball_size) / 2.0, 0.0);
  out.value(type.real_speed_max(world.params().max_dash_power) / kPlayerSpeed, 0.0);
  out.value(type.player_decay, 0.0);
  out.flag(world.referee.touch.toucher == slot);
}

/// Where the attackers of `side` are offside, in its own coordinates: the second last opponent, the
/// ball, or the half-way line.
double offside_line(const simulator::World& world, const Cast& cast, Side side) {
  const int sign = soccer::sign(side);
  double last = 0.0;
  double second = 0.0;
  for (const int slot : cast.others(side)) {
    if (!world.player(slot).enabled) continue;
    const double x = world.player(slot).position.x * sign;
    second = std::max(second, std::min(last, x));
    last = std::max(last, x);
  }
  return std::max(second, world.ball.position.x * sign);
}

void append_referee(Columns& out) {
  append_mode(out);
  append(out, "", {"set_play_cycles"}, "100 cycles", 0);
  append(out, "", {"touched_by_left"});  // -1: by the right team, 0: by none
  append(out, "", {"left_offside_line", "right_offside_line"}, "52.5 m", -1.2F, 1.2F);
}

void add_referee(const simulator::World& world, const Cast& cast, FeatureWriter& out) {
  add_mode(out, world.mode, Side::kLeft);
  out.value(world.referee.free_kick.timer / 100.0, 0.0);
  const int toucher = world.referee.touch.toucher;
  out.value(toucher == simulator::kNoPlayer ? 0 : soccer::sign(soccer::side_of_slot(toucher)));
  for (const Side side : soccer::kBothSides) {
    out.value(offside_line(world, cast, side) / soccer::kHalfLength, -1.2, 1.2);
  }
}

}  // namespace

Columns state_columns(const Cast& cast, int version) {
  Columns out = {{"ball_x", "52.5 m", -1.2F, 1.2F},
                 {"ball_y", "34 m", -1.2F, 1.2F},
                 {"ball_vx", "3 m/cycle", -1, 1},
                 {"ball_vy", "3 m/cycle", -1, 1},
                 {"play_on", "0/1", -1, 1},
                 {"time_left", "1", 0, 1},
                 {"score_difference", "goals", -20, 20}};

  for (const Side side : soccer::kBothSides) {
    for (const int slot : cast.team(side)) {
      const std::string name = agent_name(slot);
      append(out, name, {"_on_pitch"}, "0/1");
      append(out, name, {"_x"}, "52.5 m", -1.2F, 1.2F);
      append(out, name, {"_y"}, "34 m", -1.2F, 1.2F);
      append(out, name, {"_vx", "_vy"}, "1.2 m/cycle");
      append(out, name, {"_body_sin", "_body_cos"});
      append(out, name, {"_stamina"}, "8000", 0);
    }
  }
  if (version == 1) return out;

  append_referee(out);
  for (const Side side : soccer::kBothSides) {
    for (const int slot : cast.team(side)) append_condition(out, agent_name(slot));
  }
  return out;
}

void fill_state(const simulator::World& world, const Cast& cast, int version, double time_left,
                float* numbers) {
  FeatureWriter out(numbers);
  out.value(world.ball.position.x / soccer::kHalfLength, -1.2, 1.2);
  out.value(world.ball.position.y / soccer::kHalfWidth, -1.2, 1.2);
  out.value(world.ball.velocity.x / kBallSpeed);
  out.value(world.ball.velocity.y / kBallSpeed);
  out.flag(world.mode == soccer::PlayMode::kPlayOn);
  out.value(time_left, 0.0);
  out.value(world.team(Side::kLeft).score - world.team(Side::kRight).score, -20.0, 20.0);

  for (const Side side : soccer::kBothSides) {
    for (const int slot : cast.team(side)) add_player(world, slot, out);
  }
  if (version == 1) return;

  add_referee(world, cast, out);
  for (const Side side : soccer::kBothSides) {
    for (const int slot : cast.team(side)) add_condition(world, slot, out);
  }
}

}  // namespace cls::training
