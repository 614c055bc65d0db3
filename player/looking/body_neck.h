// Body and neck actions: face a point or the ball, scan the field.
#pragma once

#include "player/commands/command_slots.h"
#include "player/world/view_cone.h"
#include "player/world/world_model.h"

namespace cls::player {

// docs/spec/proxy-behavior.md 4.4. All set the body slot, and fall back to scan_field() without a
// valid own (or ball) position.

/// Turns the body to the point; the neck adds what one turn cannot reach.
bool body_neck_to_point(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                        soccer::Vec2 point);
bool body_neck_to_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

/// Turns only the neck if it reaches the point with `angle_buf` degrees margin, otherwise also the
/// body.
bool neck_body_to_point(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                        soccer::Vec2 point, double angle_buf);
bool neck_body_to_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                       double angle_buf);

/// Turns around with a wide view; searches a lost ball at its last seen position, then in the
/// direction unseen for longest.
bool scan_field(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

/// Regains orientation: scan_field() with high view quality.
bool emergency(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

/// Turns body and neck to the direction unseen for longest.
bool look_around(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

}  // namespace cls::player
