// The cycle.
#include "simulator/step.h"

#include <algorithm>

#include "simulator/actions/legs.h"
#include "simulator/motion/motion.h"
#include "simulator/referee/auto_mode.h"
#include "simulator/referee/referee.h"
#include "simulator/world/stamina.h"

namespace cls::simulator {
namespace {

void count_down(int& counter, int floor) {
  if (counter > floor) --counter;
}

// Frees the commands of a new cycle; a tackling or fouled player stays blocked (2.4).
void reset_commands(Player& player) {
  count_down(player.kick_cycles, -1);
  count_down(player.dash_cycles, -1);
  count_down(player.tackle_cycles, 0);
  count_down(player.foul_cycles, 0);
  if (player.kick_cycles <= 0 && player.tackle_cycles == 0 && player.foul_cycles == 0) {
    player.command_done = false;
  }
  player.turn_neck_done = false;
  player.legs = {};
}

void use_commands(World& world) {
  for (Player& player : world.players) {
    use_legs(world, player);
    reset_commands(player);
    ++player.arm.age;
  }
}

void advance_clock(Clock& clock) { clock = {clock.time + 1, 0}; }

void run_waiting(World& world, Events& events) {
  turn_players(world);
  ++world.clock.stoppage;
  run_referee(world, events);
}

void run_stopped(World& world, Events& events) {
  const PlayMode before = world.mode;
  world.ball_catcher = kNobody;
  move_objects(world, events);
  ++world.clock.stoppage;
  run_referee(world, events);
  if (world.mode != before) advance_clock(world.clock);
}

// The clock runs between motion and referee: contacts carry the old time, calls the new one.
void run_playing(World& world, Events& events) {
  move_objects(world, events);
  advance_clock(world.clock);
  run_referee(world, events);
}

void rest(World& world) {
  const soccer::ServerParams& server = world.params();
  for (Player& player : world.players) {
    if (!player.enabled) continue;
    update_stamina(world, player);
    Ears& ears = player.ears;
    ears.teammate_capacity = std::min(ears.teammate_capacity + server.hear_inc, server.hear_max);
    ears.opponent_capacity = std::min(ears.opponent_capacity + server.hear_inc, server.hear_max);
    count_down(player.catch_ban, 0);
  }
}

// What a frame shows once; tackles and fouls are shown as long as they block (12.2).
void clear_transient_state(Player& player) {
  std::uint32_t kept =
      state::kStand | state::kGoalie | state::kDiscard | state::kYellowCard | state::kRedCard;
  if (player.kick_cycles > 0) kept |= state::kKick | state::kKickFault;
  if (player.tackle_cycles > 0) kept |= state::kTackle | state::kTackleFault;
  if (player.foul_cycles > 0) kept |= state::kFoulCharged;
  player.state &= kept;
}

}  // namespace

void step(World& world, Events& events) {
  use_commands(world);
  switch (soccer::mode_class(world.mode)) {
    case soccer::ModeClass::kWaiting:
      run_waiting(world, events);
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
  rest(world);
}

void finish_step(World& world, Events& events) {
  for (Player& player : world.players) clear_transient_state(player);
  run_auto_mode(world, events);
}

}  // namespace cls::simulator
