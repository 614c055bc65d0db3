// The shoot-out.
#pragma once

#include "proxy/planner/action_context.h"

namespace cls::proxy {

/// Taker, goalie or one of those who wait. False outside the shoot-out's modes and on the ground.
bool play_penalty(ActionContext& context);

/// The agent takes our present kick.
bool is_penalty_taker(const WorldModel& world);

}  // namespace cls::proxy
