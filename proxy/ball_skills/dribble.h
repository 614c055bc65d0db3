// Running with the ball.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/commands/intention.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

struct DribbleOptions {
  double threshold = 1.0;  ///< arrived when nearer, metres
  double dash_power = 100.0;
  int dash_count = 1;  ///< dashes between two kicks, 1 to 10
  bool dodge = false;  ///< around opponents
};

/// Takes the ball toward `target`: goes for it when it is not kickable, holds it when there. A kick
/// ahead leaves an intention to run after it. False only on the ground.
bool dribble(const WorldModel& world, Intention& intention, CommandSlots& slots,
             soccer::Vec2 target, const DribbleOptions& options);

/// Runs on after the ball. False, ending the intention, when that no longer makes sense: somebody
/// else is at the ball, it is out of reach, or the way is done.
bool continue_dribble(const WorldModel& world, Intention& intention, CommandSlots& slots);

}  // namespace cls::proxy
