// Intercept prediction: which player reaches the ball, and when.
#pragma once

#include <array>

#include "player/world/world_model.h"

namespace cls::player {

/// Prediction horizon in cycles.
constexpr int kInterceptHorizon = FullRun::kCycles;

/// Ball positions by cycle from now, without touches.
using BallPath = std::array<soccer::Vec2, kInterceptHorizon + 1>;
BallPath ball_path(const WorldModel& world);

/// Adds the agent's intercept plans to the table: straight dashes in eight directions, and turns
/// followed by forward or backward dashes, with their stamina cost
/// (docs/spec/proxy-behavior.md 3.6).
void plan_self_intercept(const WorldModel& world, const BallPath& path, InterceptTable& table);

/// Sets `world.intercept` and every player's ball_reach_steps. The table is empty before kick-off,
/// after the match, and without a valid own or ball position.
void update_intercept_table(WorldModel& world);

}  // namespace cls::player
