// Evaluation of planner states: the default, or the evaluation of the Playmaker.
#pragma once

#include "proxy/planner/field.h"
#include "proxy/planner/plan.h"

namespace protos {
class PlannerEvaluation;
}

namespace cls::proxy {

/// Value of `plan.nodes[node]`, from the nodes on its path (docs/spec/proxy-behavior.md 5.4).
/// `evaluation`: the Playmaker's; null for the default.
double evaluate(const PlannerField& field, const Plan& plan, int node,
                const protos::PlannerEvaluation* evaluation);

}  // namespace cls::proxy
