// Reckons who can reach the ball, and when.
#pragma once

#include <array>

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Cycles looked ahead.
constexpr int kInterceptHorizon = 50;

/// Where the ball is now (0) and after each coming cycle when nobody touches it.
using BallPath = std::array<soccer::Vec2, kInterceptHorizon + 1>;
BallPath ball_path(const WorldModel& world);

/// The agent's own plans into the table: straight dashes in eight directions, and turns followed by
/// dashes forward or backward, with the stamina they take (proxy behaviour 3.6).
void plan_own_intercept(const WorldModel& world, const BallPath& path, InterceptTable& table);

/// Cycles until another player can have the ball; kNever beyond the horizon. An old belief about
/// the player is counted in his favour.
int reach_steps(const WorldModel& world, const PlayerState& player, const BallPath& path);

/// Fills `world.intercept` and every player's ball_reach_steps. Before kick-off, after the match
/// and without own or ball position nothing is known.
void reckon_intercepts(WorldModel& world);

}  // namespace cls::proxy
