// Evaluation of planner states.
#pragma once

#include <functional>

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

}  // namespace cls::player
