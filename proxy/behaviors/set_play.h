// Dead balls: ours and theirs.
#pragma once

#include "proxy/planner/action_context.h"

namespace cls::proxy {

/// The whole team's part in every mode in which the ball is dead. False on the ground.
bool play_set_play(ActionContext& context);

}  // namespace cls::proxy
