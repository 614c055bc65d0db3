// Noise-free motion of players and ball: prediction and the commands that cause it.
#pragma once

#include "player/world/running.h"
#include "player/world/world_model.h"

namespace cls::player {

// Without noise; docs/spec/simulation-model.md 3.1, 4.2 to 4.4.

/// Limits the length of a vector to `max`.
Vec2 speed_limited(Vec2 velocity, double max);

/// Position after `cycles` without acceleration (closed form).
Vec2 coast(Vec2 position, Vec2 velocity, double decay, int cycles);
/// Inertia point: where a body that never accelerates again comes to rest.
Vec2 rest_point(Vec2 position, Vec2 velocity, double decay);
/// Initial speed that covers `distance` in `cycles`.
double first_speed(double distance, int cycles, double decay);
/// `base` to a small non-negative integer power.
double power_of(double base, int exponent);

/// Turning by M degrees takes a moment of M times this factor.
double turn_resistance(const soccer::PlayerType& type, Vec2 velocity);
/// Maximum turn of the agent in this cycle, degrees.
double max_turn(const WorldModel& world);

/// Velocity added by a dash of the agent; `direction` relative to the current or given `body`.
Vec2 dash_acceleration(const WorldModel& world, double power, double direction);
Vec2 dash_acceleration(const WorldModel& world, AngleDeg body, double power, double direction);

/// Maximum dash power, at most `power`, that does not decrease recovery.
double safe_dash_power(const WorldModel& world, double power);

/// Distance within which the agent can kick.
double kickable_area(const WorldModel& world);
/// Distance below which ball and agent collide.
double collide_distance(const WorldModel& world);
/// Ball acceleration per unit of kick power, with the ball at `relative` (pitch axes).
double kick_rate(const WorldModel& world, Vec2 relative, AngleDeg body);

/// Agent position after coasting for `cycles`.
Vec2 self_after(const WorldModel& world, int cycles);
/// Ball position after rolling freely for `cycles`.
Vec2 ball_after(const WorldModel& world, int cycles);

/// Position after `cycles` of free rolling, computed cycle by cycle; coast() is the closed form and
/// differs in the last bits.
Vec2 ball_after(Vec2 position, Vec2 velocity, int cycles, double decay);

/// Where the first player of either team intercepts the ball; the current ball position if none
/// does.
Vec2 first_reach_point(const WorldModel& world);

}  // namespace cls::player
