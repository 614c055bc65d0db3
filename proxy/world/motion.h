// How bodies and ball move in the coming cycles, and which command brings them where.
#pragma once

#include "proxy/world/world_model.h"

namespace cls::proxy {

// All of it without noise; simulation model 3.1, 4.2 to 4.4.

/// A vector no longer than `max`, same direction.
soccer::Vec2 speed_limited(soccer::Vec2 velocity, double max);

/// Where something with that velocity is after `cycles` when nothing pushes it.
soccer::Vec2 coast(soccer::Vec2 position, soccer::Vec2 velocity, double decay, int cycles);
/// Where it comes to rest.
soccer::Vec2 rest_point(soccer::Vec2 position, soccer::Vec2 velocity, double decay);
/// First speed with which something covers `distance` in `cycles`.
double first_speed(double distance, int cycles, double decay);
/// `base` to the power of a small whole number.
double power_of(double base, int exponent);

/// A turn of M degrees needs a moment of M times this.
double turn_resistance(const soccer::PlayerType& type, soccer::Vec2 velocity);
/// Largest turn of the agent in this cycle, degrees.
double max_turn(const WorldModel& world);

/// Share of the power that a dash in that direction (degrees off the body) makes use of.
double dash_rate(const soccer::ServerParams& server, double direction);
/// What a dash of the agent adds to its velocity; direction relative to `body` (now, or given).
soccer::Vec2 dash_acceleration(const WorldModel& world, double power, double direction);
soccer::Vec2 dash_acceleration(const WorldModel& world, soccer::AngleDeg body, double power,
                               double direction);

/// Cycles a player of that type needs to run `distance` from rest at full power; `distance` <= 0
/// needs none.
int cycles_to_run(const soccer::ServerParams& server, const soccer::PlayerType& type,
                  double distance);

/// Largest dash power, at most `power`, that does not bring recovery to fall.
double safe_dash_power(const WorldModel& world, double power);

/// Distance within which the agent kicks.
double kickable_area(const WorldModel& world);
/// Distance below which ball and agent collide.
double collide_distance(const WorldModel& world);
/// Ball acceleration per unit of kick power, with the ball at `relative` (pitch axes).
double kick_rate(const WorldModel& world, soccer::Vec2 relative, soccer::AngleDeg body);

/// Where the agent is after coasting that many cycles.
soccer::Vec2 self_after(const WorldModel& world, int cycles);
/// Where the ball is after rolling that many cycles.
soccer::Vec2 ball_after(const WorldModel& world, int cycles);

/// Where the first of all players to reach the ball does so; its place now when nobody does.
soccer::Vec2 first_reach_point(const WorldModel& world);

}  // namespace cls::proxy
