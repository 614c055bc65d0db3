// The planner: the best first tree over what the agent and its team could do with the ball.
#pragma once

#include "proxy/planner/field.h"
#include "proxy/planner/plan.h"

namespace protos {
class HeliosOffensivePlanner;
class PlannerEvaluation;
}  // namespace protos

namespace cls::proxy {

/// What the Playmaker allows; any kind of pass allows all three, as with upstream.
PlannerOptions planner_options(const protos::HeliosOffensivePlanner& wish);

/// Plans for the agent with the ball; `wanted` changes the values (null: the default). Never
/// empty: without anything better, the root is best, which means to hold the ball.
Plan make_plan(const PlannerField& field, const PlannerOptions& options,
               const protos::PlannerEvaluation* wanted);

}  // namespace cls::proxy
