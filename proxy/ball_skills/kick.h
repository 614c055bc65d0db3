// Single kicks: the ball's next velocity as far as one kick can make it.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Largest acceleration that one kick gives the ball here and now, metres per cycle.
double kick_limit(const WorldModel& world);
/// The same with the given ball acceleration per unit of power.
double kick_limit(const WorldModel& world, double rate);

/// Largest speed along the unit vector `direction` of a ball that moves with `velocity` and gets
/// an acceleration of at most `limit`; negative when no such acceleration sends it that way.
double max_speed_along(soccer::Vec2 velocity, soccer::Vec2 direction, double limit,
                       double speed_max);

/// Kicks so that the ball's velocity becomes `velocity`, or as near to it as full power does.
bool kick_to_velocity(const WorldModel& world, CommandSlots& slots, soccer::Vec2 velocity);

/// One kick toward the point with `first_speed`, or the largest possible below it. When that
/// direction cannot be had: `force_mode` kicks as near to it as possible, else the ball is held.
bool kick_one_step(const WorldModel& world, CommandSlots& slots, soccer::Vec2 target,
                   double first_speed, bool force_mode);

/// Keeps the ball where it is relative to the moving agent. False (and `turn 0`) when it already
/// stays there by itself.
bool stop_ball(const WorldModel& world, CommandSlots& slots);

}  // namespace cls::proxy
