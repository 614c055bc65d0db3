// The HeliosOffensivePlanner action.
#pragma once

#include "proxy/planner/reply_context.h"

namespace protos {
class HeliosOffensivePlanner;
}

namespace cls::proxy {

/// Options of the Playmaker's action; any kind of pass enables all three, as in helios.
player::PlannerOptions planner_options(const protos::HeliosOffensivePlanner& action);

/// Plans by the first planner action of the reply (all share one plan) and executes the best first
/// action; holds the ball if that fails. With server_side_decision the Playmaker chooses: before
/// its choice, sets the chooser to kRequested and returns true; without a reply returns false.
/// False if the ball is not kickable.
bool run_offensive_planner(const protos::HeliosOffensivePlanner& action, ReplyContext& context);

}  // namespace cls::proxy
