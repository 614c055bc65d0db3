// Evaluation of planner states as the Playmaker asks for it.
#pragma once

#include "player/planner/field.h"
#include "player/planner/plan.h"

namespace protos {
class PlannerEvaluation;
}

namespace cls::proxy {

/// Value of `plan.nodes[node]`, from the nodes on its path (docs/spec/proxy-behavior.md 5.4).
double evaluate(const player::PlannerField& field, const player::Plan& plan, int node,
                const protos::PlannerEvaluation& evaluation);

}  // namespace cls::proxy
