// Runs the simulation step: commands, motion, clock, referee, stamina, auto mode.
#include "simulator/step.h"

#include <algorithm>

#include "simulator/actions/actions.h"
#include "simulator/motion/motion.h"
#include "simulator/referee/referee.h"
#include "simulator/world/stamina.h"

namespace cls::simulator {
namespace {

void decrement(int& counter, int min) {
  if (counter > min) --counter;
}

// Allows the commands of a new cycle; a tackling or fouled player stays blocked
// (docs/spec/simulation-model.md 2.4).
void reset_commands(Player& player) {
  decrement(player.kick_cycles, -1);
  decrement(player.dash_cycles, -1);
  decrement(player.tackle_cycles, 0);
  decrement(player.foul_cycles, 0);

  if (player.kick_cycles <= 0 && player.tackle_cycles == 0 && player.foul_cycles == 0) {
    player.command_done = false;
  }

  player.turn_neck_done = false;
  player.legs = {};
}

void apply_dashes(World& world) {
  for (Player& player : world.players) {
    ++player.arm.age;
    if (!player.joined) continue;
    apply_dash(world, player);
    reset_commands(player);
  }
}

void advance_clock(Clock& clock) { clock = {clock.time + 1, 0}; }

void run_before_kick_off(World& world, Events& events) {
  turn_players(world);
  ++world.clock.stoppage;
  run_referee(world, events);
}

void run_stopped(World& world, Events& events) {
  const PlayMode before = world.mode;
  world.ball_catcher = kNoPlayer;
  move_objects(world, events);
  ++world.clock.stoppage;
  run_referee(world, events);

  if (world.mode != before) advance_clock(world.clock);
}

// The clock advances between motion and referee: contacts have the old time, calls the new one.
void run_playing(World& world, Events& events) {
  move_objects(world, events);
  advance_clock(world.clock);
  run_referee(world, events);
}

void recover_stamina_and_hearing(World& world) {
  const soccer::ServerParams& server = world.params();
  for (Player& player : world.players) {
    if (!player.enabled) continue;
    update_stamina(world, player);

    Ears& ears = player.ears;
    ears.teammate_capacity = std::min(ears.teammate_capacity + server.hear_inc, server.hear_max);
    ears.opponent_capacity = std::min(ears.opponent_capacity + server.hear_inc, server.hear_max);
    decrement(player.catch_ban, 0);
  }
}

// Clears the bits that one frame shows; tackle and foul bits last while they block
// (docs/spec/simulation-model.md 12.2).
void clear_transient_state(Player& player) {
  std::uint32_t retained =
      state::kStand | state::kGoalie | state::kDiscard | state::kYellowCard | state::kRedCard;
  if (player.kick_cycles > 0) retained |= state::kKick | state::kKickFault;
  if (player.tackle_cycles > 0) retained |= state::kTackle | state::kTackleFault;
  if (player.foul_cycles > 0) retained |= state::kFoulCharged;
  player.state &= retained;
}

bool all_players_enabled(const World& world) {
  return std::ranges::all_of(world.players, &Player::enabled);
}

void wait_for_kick_off(World& world, Events& events) {
  AutoMode& state = world.auto_mode;
  int& wait =
      all_players_enabled(world) || world.clock.time > 0 ? state.kick_off_wait : state.connect_wait;
  if (--wait <= 0) kick_off(world, events);
}

}  // namespace

void step(World& world, Events& events) {
  apply_dashes(world);

  switch (soccer::mode_class(world.mode)) {
    case soccer::ModeClass::kWaiting:
      run_before_kick_off(world, events);
      break;
    case soccer::ModeClass::kStopped:
      run_stopped(world, events);
      break;
    case soccer::ModeClass::kRunning:
      run_playing(world, events);
      break;
    case soccer::ModeClass::kOver:
      ++world.clock.stoppage;
      break;
  }

  recover_stamina_and_hearing(world);
}

void finish_step(World& world, Events& events) {
  for (Player& player : world.players) {
    if (player.joined) clear_transient_state(player);
  }
  run_auto_mode(world, events);
}

void run_auto_mode(World& world, Events& events) {
  const soccer::ServerParams& server = world.params();
  if (!server.auto_mode) return;

  AutoMode& state = world.auto_mode;
  if (world.mode == PlayMode::kTimeOver) {
    if (--state.game_over_wait <= 0) state.ended = true;
    return;
  }

  const bool can_start = world.rules->half_time <= 0 || world.clock.time < world.rules->total_time;
  if (world.mode == PlayMode::kBeforeKickOff && can_start) {
    wait_for_kick_off(world, events);
  } else {
    state.kick_off_wait = server.kick_off_wait;
    state.connect_wait = server.connect_wait;
  }
}

}  // namespace cls::simulator
