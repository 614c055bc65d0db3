// Carrying out the first action of a plan.
#pragma once

#include "proxy/planner/action_context.h"
#include "proxy/planner/plan.h"

namespace cls::proxy {

/// Plans with all kinds of actions and the default values, and carries out the best.
bool act_on_default_plan(ActionContext& context);

/// Carries out the first action on the way to `node` (proxy behaviour 5.6): kicks it, or begins
/// to; queues the look. A dribble leaves an intention, a pass is told to its receiver. False, doing
/// nothing, without ball, and for dribbles and holds of a dead ball.
bool act_on_plan(ActionContext& context, const Plan& plan, int node);

}  // namespace cls::proxy
