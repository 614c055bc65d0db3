// Tackle actions.
#pragma once

#include "player/commands/command_slots.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Tackles the ball toward the point. False if the success probability is below `min_probability`,
/// or the ball would go more than 90 degrees off or slower than `min_speed`.
bool tackle_to_point(const WorldModel& world, CommandSlots& slots, soccer::Vec2 target,
                     double min_probability, double min_speed);

/// Tackles when an opponent has or gets the ball, or it rolls into our goal, and the success
/// probability is at least `min_probability`. Fouls intentionally where that pays.
bool basic_tackle(const WorldModel& world, CommandSlots& slots, double min_probability);

}  // namespace cls::player
