// The goalie with the ball in its hands.
#pragma once

#include "proxy/planner/action_context.h"

namespace cls::proxy {

/// After an own catch: gives the others time, moves within the penalty area to where there is room,
/// and kicks. In other situations goalie_move().
bool goalie_free_kick(ActionContext& context);

}  // namespace cls::proxy
