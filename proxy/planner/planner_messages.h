// Messages of the GetBestPlannerAction call.
#pragma once

#include "player/planner/plan.h"
#include "player/world/world_model.h"

namespace protos {
class BestPlannerActionRequest;
class State;
}  // namespace protos

namespace cls::proxy {

/// Replaces `out` with all nodes of the plan by index (0: hold; parent -1 for first actions).
/// `state` is the State of the decision, with register_response.
void fill_planner_request(const player::WorldModel& world, const player::Plan& plan,
                          const protos::State& state, protos::BestPlannerActionRequest& out);

/// First action on the path to the chosen node; the best of the plan for an invalid index.
int first_action_of(const player::Plan& plan, int chosen);

}  // namespace cls::proxy
