// Automatic kick-offs.
#include "simulator/referee/auto_mode.h"

#include <algorithm>

#include "simulator/referee/referee.h"

namespace cls::simulator {
namespace {

bool everybody_is_here(const World& world) {
  return std::all_of(world.players.begin(), world.players.end(),
                     [](const Player& player) { return player.enabled; });
}

void wait_for_kick_off(World& world, Events& events) {
  AutoMode& state = world.auto_mode;
  int& wait =
      everybody_is_here(world) || world.clock.time > 0 ? state.kick_off_wait : state.connect_wait;
  if (--wait <= 0) kick_off(world, events);
}

}  // namespace

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
