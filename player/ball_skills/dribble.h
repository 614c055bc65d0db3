// Dribble action and its intention.
#pragma once

#include "player/commands/command_slots.h"
#include "player/commands/intention.h"
#include "player/world/world_model.h"

namespace cls::player {

struct DribbleOptions {
  double threshold = 1.0;  ///< arrived within this distance, meters
  double dash_power = 100.0;
  int dash_count = 1;  ///< dashes between kicks, 1 to 10
  bool dodge = false;  ///< avoid opponents
};

/// Dribbles toward `target`: intercepts the ball if it is not kickable, holds it at the target. A
/// kick ahead leaves an intention to run after the ball. False only if frozen.
bool dribble(const WorldModel& world, Intention& intention, CommandSlots& slots,
             soccer::Vec2 target, const DribbleOptions& options);

/// Continues the dribble. False, clearing the intention, when it is invalid: another player has the
/// ball, it is out of reach, or the dribble is finished.
bool continue_dribble(const WorldModel& world, Intention& intention, CommandSlots& slots);

}  // namespace cls::player
