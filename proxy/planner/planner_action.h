// The planner as an action of the wire.
#pragma once

#include "proxy/planner/action_context.h"

namespace protos {
class HeliosOffensivePlanner;
}

namespace cls::proxy {

/// Plans as the first planner action of the reply's list says (several share one plan) and carries
/// out the best first action; when that cannot be done the ball is held. With
/// server_side_decision the choice is the Playmaker's: not made yet, this marks the context as
/// wanting it and returns true; failed, it returns false. False without the ball.
bool offensive_planner(const protos::HeliosOffensivePlanner& wish, ActionContext& context);

}  // namespace cls::proxy
