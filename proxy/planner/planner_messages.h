// The plan on the wire: GetBestPlannerAction.
#pragma once

#include "proxy/planner/plan.h"
#include "proxy/world/world_model.h"

namespace protos {
class BestPlannerActionRequest;
class State;
}  // namespace protos

namespace cls::proxy {

/// Replaces `out` with all nodes of the plan: index 0 is holding the ball, the others are numbered
/// as they were made; parent -1 for first actions. `state` is the decision's, identity included.
void fill_planner_request(const WorldModel& world, const Plan& plan, const protos::State& state,
                          protos::BestPlannerActionRequest& out);

/// The first action that leads to the chosen node; the plan's own best for an index without node.
int first_action_of(const Plan& plan, int chosen);

}  // namespace cls::proxy
