// Time rule: ends halves and the match; the kick-off command starts a half
// (docs/spec/simulation-model.md 9.6).
#include "simulator/referee/clearing.h"
#include "simulator/referee/rule.h"
#include "simulator/referee/substitution.h"
#include "simulator/world/stamina.h"

namespace cls::simulator {
namespace {

bool is_level(const World& world) {
  return world.team(Side::kLeft).score == world.team(Side::kRight).score;
}

Side kick_off_side_of_half(int half) { return half % 2 == 0 ? Side::kLeft : Side::kRight; }

void end_match(World& world, std::string_view message, Events& events) {
  announce(world, {message}, events);
  change_mode(world, PlayMode::kTimeOver, events);
}

int start_of_half(const World& world, int half) {
  const Rules& rules = *world.rules;
  const int extra = half - rules.server.nr_normal_halfs;
  return extra >= 0 ? rules.normal_time + rules.extra_half_time * extra : rules.half_time * half;
}

// Restores only the capacity, and only before the first extra half
// (docs/spec/simulation-model.md 5).
void restore_capacity(World& world) {
  for (Player& player : world.players) {
    if (player.enabled) player.stamina.capacity = world.params().stamina_capacity;
  }
}

void end_half(World& world, std::string_view message, Events& events) {
  const int half = ++world.referee.time.finished_halves;
  announce(world, {message}, events);

  world.ball_catcher = kNoPlayer;
  place_ball(world, PlayMode::kBeforeKickOff, kick_off_side_of_half(half), {}, events);
  world.clock.time = start_of_half(world, half);

  if (half == world.params().nr_normal_halfs) restore_capacity(world);
  world.wind.vector = -world.wind.vector;
  keep_players_in_own_half(world);
}

void analyze_extra_time(World& world, Events& events) {
  const Rules& rules = *world.rules;
  if (!world.team(Side::kLeft).connected || !world.team(Side::kRight).connected) {
    end_match(world, "time_up_without_a_team", events);
    return;
  }

  if (rules.server.golden_goal && !is_level(world)) {
    end_match(world, "time_up", events);
    return;
  }

  const int extra_halves = world.referee.time.finished_halves + 1 - rules.server.nr_normal_halfs;
  if (world.clock.time < rules.normal_time + rules.extra_half_time * extra_halves) return;

  if (extra_halves == 0 && !is_level(world)) {
    end_match(world, "time_up", events);
  } else {
    end_half(world, "time_extended", events);
  }
}

void analyze(World& world, Events& events) {
  const Rules& rules = *world.rules;
  if (soccer::mode_class(world.mode) != soccer::ModeClass::kRunning || rules.half_time <= 0) {
    return;
  }

  const int time = world.clock.time;
  if (time >= rules.total_time) {
    const bool has_shoot_out = rules.server.penalty_shoot_outs && is_level(world);
    if (!has_shoot_out) end_match(world, "time_up", events);
  } else if (time >= rules.normal_time) {
    analyze_extra_time(world, events);
  } else if (time >= rules.half_time * (world.referee.time.finished_halves + 1)) {
    end_half(world, "half_time", events);
  }
}

/// Index of the half that starts at the current time, if any.
std::optional<int> starting_half(const World& world) {
  const Rules& rules = *world.rules;
  const int time = world.clock.time;
  if (rules.half_time <= 0) {  // unlimited halves may start at any time
    // rcssserver rounds a negative half up: -1 s is -9 cycles.
    const int half = rules.half_time < 0 ? rules.half_time + 1 : 0;
    const int normal = half * rules.server.nr_normal_halfs;
    const int length = time > normal ? rules.extra_half_time : half;
    return length <= 0 ? 0 : (time - normal) / length;
  }

  if (time <= rules.normal_time && time % rules.half_time == 0) return time / rules.half_time;

  const int extra = time - rules.normal_time;
  if (extra > 0 && rules.extra_half_time > 0 && extra % rules.extra_half_time == 0) {
    return extra / rules.extra_half_time;
  }
  return std::nullopt;
}

}  // namespace

const Rule kTimeRule = {.analyze = analyze};

void kick_off(World& world, Events& events) {
  if (world.params().keepaway) {
    change_mode(world, PlayMode::kPlayOn, events);
    return;
  }

  const std::optional<int> half = starting_half(world);
  if (!half) return;

  const Side side = kick_off_side_of_half(*half);
  if (world.clock.time < world.rules->normal_time) recover_all(world);
  place_ball(world, side, {});

  if (world.clock.time == 0 && side == Side::kLeft) {
    for (const Side team : {Side::kLeft, Side::kRight}) assign_types(world, team, events);
  }
  change_mode(world, for_side(PlayMode::kKickOffLeft, side), events);
}

}  // namespace cls::simulator
