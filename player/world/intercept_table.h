// Intercept table: the agent's intercept plans, and the intercept cycles of all players.
#pragma once

#include <cstdint>

#include "base/fixed_list.h"
#include "player/world/age.h"
#include "soccer/angle.h"
#include "soccer/geometry.h"

namespace cls::player {

/// One way for the agent to intercept the ball: turns, then dashes. Without turns, the first dash
/// may turn the body by `turn_angle` (leg_turn() with `dash_power`).
struct InterceptPlan {
  enum class Kind : std::uint8_t { kOmniDash, kTurnForwardDash, kTurnBackwardDash };

  Kind kind = Kind::kOmniDash;
  int turns = 0;
  int dashes = 0;
  bool leg_turn = false;        ///< the first dash turns the body
  bool exhausting = false;      ///< drops stamina below the threshold where recovery decreases
  double turn_angle = 0.0;      ///< total, degrees, relative to the body
  double dash_power = 0.0;      ///< of the first dash
  double dash_direction = 0.0;  ///< degrees relative to the body after turning
  soccer::Vec2 self_position;   ///< own position at the end
  double ball_distance = 0.0;   ///< to the ball at the end
  double stamina = 0.0;         ///< left at the end

  int steps() const { return turns + dashes; }
};

constexpr std::size_t kMaxInterceptPlans = 64;

/// Steps are cycles from now; kNever: cannot reach it, or unknown. Ids are PlayerState::id; 0:
/// none.
struct InterceptTable {
  int self_steps = kNever;             ///< of the fastest non-exhausting plan
  int self_exhausting_steps = kNever;  ///< of the fastest exhausting plan
  int first_teammate_steps = kNever;
  int second_teammate_steps = kNever;
  int first_opponent_steps = kNever;
  int second_opponent_steps = kNever;
  int first_teammate_id = 0;
  int second_teammate_id = 0;
  int first_opponent_id = 0;
  int second_opponent_id = 0;
  base::FixedList<InterceptPlan, kMaxInterceptPlans> plans;  ///< by steps, ascending

  /// Minimum over exhausting and other plans.
  int best_self_steps() const {
    return self_steps < self_exhausting_steps ? self_steps : self_exhausting_steps;
  }
};

}  // namespace cls::player
