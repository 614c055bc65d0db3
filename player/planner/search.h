// The offensive planner: best-first search over actions of the agent and its team.
#pragma once

#include "player/planner/evaluation.h"
#include "player/planner/field.h"
#include "player/planner/plan.h"

namespace cls::player {

/// Plans for the agent with the ball. Never empty: the root means hold.
Plan make_plan(const PlannerField& field, const PlannerOptions& options,
               const NodeValue& value = default_value);

}  // namespace cls::player
