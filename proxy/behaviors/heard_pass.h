// Receiving a pass that the passer called out.
#pragma once

#include "proxy/planner/action_context.h"

namespace cls::proxy {

/// When a teammate told in this cycle that it passes to the agent: goes for the ball, or to the
/// place it named, and leaves the intention to go on. False when there was no such call.
bool receive_heard_pass(ActionContext& context);

/// Goes on. False, ending the intention, when the ball is there, somebody of ours has it, or time
/// is up.
bool continue_reception(ActionContext& context);

}  // namespace cls::proxy
