// Single kicks.
#pragma once

#include "player/commands/command_slots.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Maximum ball acceleration by one kick now, meters per cycle.
double kick_limit(const WorldModel& world);
/// The kick limit for a given kick rate.
double kick_limit(const WorldModel& world, double rate);

/// Maximum speed along the unit vector `direction` of a ball with `velocity` after an acceleration
/// of at most `limit`; negative if that direction is impossible.
double max_speed_along(soccer::Vec2 velocity, soccer::Vec2 direction, double limit,
                       double speed_max);

/// Kicks so that the ball velocity becomes `velocity`, or as near as full power allows.
bool kick_to_velocity(const WorldModel& world, CommandSlots& slots, soccer::Vec2 velocity);

/// One kick toward the point with `first_speed`, or the highest possible speed below it. If the
/// direction is impossible: with `force_mode` kicks as near to it as possible, otherwise holds the
/// ball.
bool kick_one_step(const WorldModel& world, CommandSlots& slots, soccer::Vec2 target,
                   double first_speed, bool force_mode);

/// True if a ball beside the agent is not at rest where it can be kicked: stop_ball() would kick.
bool stop_needs_kick(const WorldModel& world);

/// Keeps the ball at its position relative to the moving agent. False (and `turn 0`) if no kick is
/// needed.
bool stop_ball(const WorldModel& world, CommandSlots& slots);

}  // namespace cls::player
