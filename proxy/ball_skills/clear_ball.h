// Kicking the ball away: forward, out of danger, or out of a scramble.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// A long kick upfield where opponents leave most room. False when the ball is not kickable.
bool advance_ball(const WorldModel& world, CommandSlots& slots);

/// The hardest kick into a free direction, toward the touch line ahead first.
bool clear_ball(const WorldModel& world, CommandSlots& slots);

/// In open play, when an opponent can kick the ball too (goalies excepted): at once at their goal,
/// or in front of it from the wing. False when that is not the situation.
bool force_kick(const WorldModel& world, CommandSlots& slots);

}  // namespace cls::proxy
