// The offensive planner: search over actions of the agent and its team, evaluation, outlets.
#pragma once

#include <functional>
#include <optional>

#include "player/planner/field.h"
#include "player/planner/plan.h"

namespace cls::player {

/// Value of `plan.nodes[node]`, from the nodes on its path.
using NodeValue = std::function<double(const PlannerField& field, const Plan& plan, int node)>;

/// Default value, as in helios with changes: the goal line beside the goal is not better than a few
/// meters before it; near opponents and long ball possession cost; time and number of actions cost,
/// so of equal results the most direct one wins.
double default_value(const PlannerField& field, const Plan& plan, int node);

struct FieldWeights {
  double x = 0.0;
  double goal_distance = 0.0;
  double goal_radius = 0.0;
};

/// Value of the ball at its place, with bonuses for goals and chances to shoot.
double ball_value(const PlannerField& field, const PlanNode& state, const FieldWeights& weights);

/// Plans for the agent with the ball. Never empty: the root means hold.
Plan make_plan(const PlannerField& field, const PlannerOptions& options,
               const NodeValue& value = default_value);

/// A long ball by one kick.
struct Outlet {
  Vec2 target;                  ///< where a player gets it or it leaves the pitch
  double speed = 0.0;           ///< first, meters per cycle
  bool teammate_first = false;  ///< a teammate gets it first
  double value = 0.0;           ///< comparable only between outlets of the same step
};

/// Best outlet; empty if no kick is possible. Outlets that a teammate gets with time to spare are
/// best; otherwise those far from our goal and near a touch line.
std::optional<Outlet> best_outlet(const PlannerField& field);

}  // namespace cls::player
