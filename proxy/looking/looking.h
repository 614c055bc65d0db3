// Looking with body and neck together: at a point, at the ball, around.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/world/sight_memory.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

// Proxy behaviour 4.4. All of them take the body slot and fall back to scan_field() when the own
// place (or the ball's) is not known.

/// Body to the point; the neck straight ahead, or what is missing when one turn is not enough.
bool body_neck_to_point(const WorldModel& world, const SightMemory& sight, CommandSlots& slots,
                        soccer::Vec2 point);
bool body_neck_to_ball(const WorldModel& world, const SightMemory& sight, CommandSlots& slots);

/// Neck alone if it gets there with `angle_buf` degrees to spare, else the body helps.
bool neck_body_to_point(const WorldModel& world, const SightMemory& sight, CommandSlots& slots,
                        soccer::Vec2 point, double angle_buf);
bool neck_body_to_ball(const WorldModel& world, const SightMemory& sight, CommandSlots& slots,
                       double angle_buf);

/// Turns around with wide eyes; a lost ball is looked for where it was, then where nobody looked
/// for longest.
bool scan_field(const WorldModel& world, const SightMemory& sight, CommandSlots& slots);

/// Finds out where everything is, at any price: scan_field() with high quality of view.
bool emergency(const WorldModel& world, const SightMemory& sight, CommandSlots& slots);

/// Stands and looks where nothing was seen for longest: body and neck.
bool look_around(const WorldModel& world, const SightMemory& sight, CommandSlots& slots);

}  // namespace cls::proxy
