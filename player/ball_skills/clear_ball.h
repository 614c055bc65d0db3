// Long kicks: advance, clear, force kick.
#pragma once

#include "player/commands/command_slots.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Kicks far upfield in the direction with the most space. False if the ball is not kickable.
bool advance_ball(const WorldModel& world, CommandSlots& slots);

/// Kicks with full power in a free direction, preferably toward the touch line ahead.
bool clear_ball(const WorldModel& world, CommandSlots& slots);

/// In open play, when an opponent can also kick the ball: kicks immediately toward their goal, or
/// in front of it from the wing. False otherwise, and for goalies.
bool force_kick(const WorldModel& world, CommandSlots& slots);

}  // namespace cls::player
