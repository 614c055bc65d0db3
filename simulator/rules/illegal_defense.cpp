// Illegal defense rule: too many players in front of the own goal for too long
// (docs/spec/simulation-model.md 9.13).
#include <cmath>

#include "simulator/referee/rule.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

constexpr double kFreeKickX = 41.5;

void kick_taken(World& world, Player& kicker, double, Events&) {
  IllegalDefenseState& state = world.referee.illegal_defense;
  const bool both = state.kick_time == world.clock.time && state.kicker_side != kicker.side;
  state.kicker_side = both ? Side::kNeutral : kicker.side;
  state.kick_time = world.clock.time;
}

bool is_in_area(const World& world, const Player& player) {
  const soccer::ServerParams& server = world.params();
  return -player.position.x * sign(player.side) >
             soccer::kHalfLength - server.illegal_defense_dist_x &&
         std::fabs(player.position.y) < server.illegal_defense_width / 2.0;
}

int count_defenders(World& world, Side side) {
  const bool under_attack = world.referee.illegal_defense.kicker_side == opponent(side) &&
                            world.ball.position.x * sign(side) < 0.0;
  int count = 0;
  for (Player& player : world.players) {
    if (!under_attack || !player.enabled || player.side != side || !is_in_area(world, player)) {
      continue;
    }
    player.state |= state::kIllegalDefense;
    ++count;
  }
  return count;
}

void clear_state_bits(World& world, Side side) {
  for (Player& player : world.players) {
    if (player.side == side) player.state &= ~state::kIllegalDefense;
  }
}

void call_illegal_defense(World& world, Side side, Events& events) {
  world.ball_catcher = kNoPlayer;
  place_ball(world, for_side(PlayMode::kIllegalDefenseLeft, side), opponent(side),
             {-kFreeKickX * sign(side), 0.0}, events);
}

int& cycles_of(World& world, Side side) {
  return world.referee.illegal_defense.counters[side == Side::kRight ? 1 : 0];
}

void count_cycles(World& world, Side side) {
  int& cycles = cycles_of(world, side);
  if (count_defenders(world, side) >= world.params().illegal_defense_number) {
    ++cycles;
  } else {
    cycles = 0;
    clear_state_bits(world, side);
  }
}

// With duration 0 both sides can be called in one step; the call of the right side prevails.
void analyze(World& world, Events& events) {
  const soccer::ServerParams& server = world.params();
  if (server.illegal_defense_number <= 0) return;
  if (is_either(world.mode, PlayMode::kIllegalDefenseLeft)) {
    const Side offender = soccer::side(world.mode);
    if (wait_after_offense(world, world.referee.illegal_defense.counter, offender, events)) {
      change_mode(world, for_side(PlayMode::kFreeKickLeft, opponent(offender)), events);
    }
    return;
  }
  if (world.mode != PlayMode::kPlayOn) return;
  for (const Side side : {Side::kLeft, Side::kRight}) count_cycles(world, side);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    int& cycles = cycles_of(world, side);
    if (cycles < server.illegal_defense_duration) continue;
    cycles = 0;
    call_illegal_defense(world, side, events);
  }
}

void mode_changed(World& world, PlayMode mode, Events&) {
  if (is_either(mode, PlayMode::kIllegalDefenseLeft)) world.referee.illegal_defense.counter = 0;
}

}  // namespace

const Rule kIllegalDefenseRule = {
    .analyze = analyze, .kick_taken = kick_taken, .mode_changed = mode_changed};

}  // namespace cls::simulator
