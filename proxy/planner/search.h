// The offensive planner: best-first search over actions of the agent and its team.
#pragma once

#include "proxy/planner/field.h"
#include "proxy/planner/plan.h"

namespace protos {
class HeliosOffensivePlanner;
class PlannerEvaluation;
}  // namespace protos

namespace cls::proxy {

/// Options of the Playmaker's action; any kind of pass enables all three, as in helios.
PlannerOptions planner_options(const protos::HeliosOffensivePlanner& action);

/// Plans for the agent with the ball; `evaluation` null: the default. Never empty: the root means
/// hold.
Plan make_plan(const PlannerField& field, const PlannerOptions& options,
               const protos::PlannerEvaluation* evaluation);

}  // namespace cls::proxy
