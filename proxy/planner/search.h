// The offensive planner: best-first search over actions of the agent and its team.
#pragma once

#include "proxy/planner/evaluation.h"
#include "proxy/planner/field.h"
#include "proxy/planner/plan.h"

namespace cls::proxy {

/// Plans for the agent with the ball. Never empty: the root means hold.
Plan make_plan(const PlannerField& field, const PlannerOptions& options,
               const NodeValue& value = default_value);

}  // namespace cls::proxy
