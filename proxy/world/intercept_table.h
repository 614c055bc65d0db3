// Who reaches the ball when: the agent's own plans and the steps of everybody else.
#pragma once

#include <cstdint>

#include "proxy/world/age.h"
#include "proxy/world/fixed_list.h"
#include "soccer/angle.h"
#include "soccer/geometry.h"

namespace cls::proxy {

/// One way for the agent to get to the ball: turns first, then dashes.
struct InterceptPlan {
  enum class Kind : std::uint8_t { kOmniDash, kTurnForwardDash, kTurnBackwardDash };

  Kind kind = Kind::kOmniDash;
  int turns = 0;
  int dashes = 0;
  bool exhausting = false;      ///< takes stamina below the point where recovery falls
  double turn_angle = 0.0;      ///< total, degrees, relative to the body
  double dash_power = 0.0;      ///< of the first dash
  double dash_direction = 0.0;  ///< degrees relative to the body after turning
  soccer::Vec2 self_position;   ///< own position at the end
  double ball_distance = 0.0;   ///< to the ball at the end
  double stamina = 0.0;         ///< left at the end

  int steps() const { return turns + dashes; }
};

constexpr std::size_t kMaxInterceptPlans = 64;

/// Steps are cycles from now; kNever: cannot, or nothing known. Ids are PlayerState::id, 0: nobody.
struct InterceptTable {
  int self_steps = kNever;             ///< of the quickest plan that does not exhaust
  int self_exhausting_steps = kNever;  ///< of the quickest plan that does
  int first_teammate_steps = kNever;
  int second_teammate_steps = kNever;
  int first_opponent_steps = kNever;
  int second_opponent_steps = kNever;
  int first_teammate_id = 0;
  int second_teammate_id = 0;
  int first_opponent_id = 0;
  int second_opponent_id = 0;
  FixedList<InterceptPlan, kMaxInterceptPlans> plans;  ///< by steps, ascending

  /// The quicker of both kinds of own plan.
  int best_self_steps() const {
    return self_steps < self_exhausting_steps ? self_steps : self_exhausting_steps;
  }
};

}  // namespace cls::proxy
