// What a player says and to whom it listens when nobody decided otherwise.
#pragma once

#include "proxy/planner/action_context.h"

namespace cls::proxy {

/// Tells what the agent sees and others may not: the ball near it, the opponents and teammates seen
/// just now; listens to the teammate nearest to the ball. Fills what is left of this cycle's say
/// and leaves the ears alone when attention was set. False when it adds nothing.
bool communicate(ActionContext& context);

}  // namespace cls::proxy
