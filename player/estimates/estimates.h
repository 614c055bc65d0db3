// Estimates for a decision: ball control, intercept table, defense and offside lines.
#pragma once

#include <array>

#include "player/world/world_model.h"

namespace cls::player {

/// Sets kickable, kick_rate, the catch, tackle and foul probabilities and the safe dash power of
/// `world.self` (docs/spec/proxy-behavior.md 3.4). Foul probabilities assume that an opponent has
/// the ball.
void update_action_probabilities(WorldModel& world);

/// Maximum catch distance of a goalie, and the distance within which a catch is reliable.
struct CatchReach {
  double sure = 0.0;
  double farthest = 0.0;
};
CatchReach catch_reach(const WorldModel& world);

/// Sets kickable_teammate_id and kickable_opponent_id (docs/spec/proxy-behavior.md 3.7).
void update_kickable_players(WorldModel& world);

/// Updates last_kick from own kicks, kick marks in see messages, and jumps of the ball velocity
/// while only one team could kick. Uses the kickable players of the previous decision: call it
/// before update_kickable_players().
void update_last_kicker(WorldModel& world);

/// Prediction horizon in cycles.
constexpr int kInterceptHorizon = FullRun::kCycles;

/// Ball positions by cycle from now, without touches.
using BallPath = std::array<Vec2, kInterceptHorizon + 1>;
BallPath ball_path(const WorldModel& world);

/// Adds the agent's intercept plans of at most `most_steps` steps to the table: straight dashes in
/// eight directions, and turns followed by forward or backward dashes, with their stamina cost
/// (docs/spec/proxy-behavior.md 3.6). `most_steps` is at most kInterceptHorizon.
void plan_self_intercept(const WorldModel& world, const BallPath& path, int most_steps,
                         InterceptTable& table);

/// The agent's own plans of an intercept table.
enum class OwnPlans {
  kAll,
  kFirst,  ///< those that take no longer than the first other player; steps of others are kNever
};

/// Sets `world.intercept` and every player's ball_reach_steps. The table is empty before kick-off,
/// after the match, and without a valid own or ball position.
void update_intercept_table(WorldModel& world, OwnPlans own = OwnPlans::kAll);

/// Sets `world.lines` (docs/spec/proxy-behavior.md 3.7) from players, ball and intercept table.
void update_team_lines(WorldModel& world);

}  // namespace cls::player
