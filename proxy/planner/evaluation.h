// What a state is worth: the default, and what Playmakers ask for instead.
#pragma once

#include "proxy/planner/field.h"
#include "proxy/planner/plan.h"

namespace protos {
class PlannerEvaluation;
}

namespace cls::proxy {

/// The value of `plan.nodes[node]`, by the nodes on the way to it (proxy behaviour 5.4).
/// `wanted`: the Playmaker's; null for the default.
double evaluate(const PlannerField& field, const Plan& plan, int node,
                const protos::PlannerEvaluation* wanted);

}  // namespace cls::proxy
