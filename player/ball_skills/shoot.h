// Shoot action.
#pragma once

#include "player/commands/command_slots.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Shoots at the goal from within 30 m where no opponent can stop the ball. False if there is no
/// such shot, in indirect free kicks, and while the clock is stopped. `aim`, if not null, receives
/// the target.
bool shoot(const WorldModel& world, CommandSlots& slots, soccer::Vec2* aim = nullptr);

}  // namespace cls::player
