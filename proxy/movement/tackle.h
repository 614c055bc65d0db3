// Tackling: a kick from farther away, at the risk of lying on the ground.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Tackles the ball toward the point. False when success is less likely than `min_probability`, or
/// the ball would go more than 90 degrees off or slower than `min_speed`.
bool tackle_to_point(const WorldModel& world, CommandSlots& slots, soccer::Vec2 target,
                     double min_probability, double min_speed);

/// Tackles when nothing better stops opponents from having the ball, or the ball from going into
/// our goal, and success is at least that likely. With intent (foul) where that pays.
bool basic_tackle(const WorldModel& world, CommandSlots& slots, double min_probability);

}  // namespace cls::proxy
