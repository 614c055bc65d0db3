// Values of planner states.
#include "player/planner/planner.h"

#include <algorithm>
#include <cmath>

#include "player/planner/generators.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

// Values of a goal, a shooting chance, one of the agent itself, and an impossible state.
constexpr double kGoal = 1e7;
constexpr double kShot = 1e6;
constexpr double kOwnShot = 5e5;
constexpr double kImpossible = 1e300;

}  // namespace

double ball_value(const PlannerField& field, const PlanNode& state, const FieldWeights& weights) {
  constexpr double kGoalLine = soccer::kHalfLength - 0.1;
  const double half_mouth = field.world.server().goal_width / 2.0 + 2.0;
  const Vec2 ball = state.ball;
  const bool between_posts = std::fabs(ball.y) < half_mouth;

  if (state.holder == 0) return -kImpossible;
  if (ball.x > kGoalLine && between_posts) return kGoal;
  if (ball.x < -kGoalLine && between_posts) return -kGoal;
  if (outside_pitch(ball)) return -kImpossible;

  const double to_goal = distance(ball, kOpponentGoal);
  double value = weights.x * (ball.x + soccer::kHalfLength) +
                 weights.goal_distance * std::max(0.0, weights.goal_radius - to_goal);

  constexpr int kShooterAge = 8;
  if (can_shoot_from(field, ball, state.holder, kShooterAge)) {
    value += kShot;
    if (state.holder == field.self.unum) value += kOwnShot;
  }

  return value;
}

double default_value(const PlannerField& field, const Plan& plan, int node) {
  const PlanNode& state = plan.at(node);
  const PlannerParameters& parameters = field.parameters;
  double value = ball_value(field, state,
                            {parameters.x_weight, parameters.goal_weight, parameters.goal_radius});

  if (value == -kImpossible) return value;
  value -=
      parameters.cycle_cost * state.time + parameters.action_cost * std::max(0, state.depth - 1);
  if (std::fabs(value) >= kShot / 2.0) return value;

  const Vec2 ball = state.ball;
  if (std::fabs(ball.y) > parameters.deep_y) {
    value -= parameters.deep_cost * std::max(0.0, ball.x - parameters.deep_x);
  }

  const double close = parameters.pressure_distance;
  const double room = nearest_opponent(field, ball);
  if (state.depth > 0 && room < close) value -= parameters.pressure_cost * (close - room);

  if (state.depth == 0) {
    const int held_long = field.held - parameters.hold_cycles;
    value -= std::clamp(parameters.hold_cost * held_long, 0.0, parameters.hold_limit);
    value -= parameters.hold_pressure_cost * std::max(0.0, close - room);
  }

  return value;
}

}  // namespace cls::player
