// Bringing a dead ball into play.
#pragma once

#include "proxy/planner/action_context.h"

namespace cls::proxy {

/// The best planned pass; else one to the nearest teammate with room; else far away upfield. False
/// only when the ball is not kickable.
bool kick_into_play(ActionContext& context);

/// The best outlet (planner/outlet.h), for where a lost ball costs a goal. False only when the ball
/// is not kickable.
bool kick_outlet(ActionContext& context);

/// The planned pass alone; false when there is none.
bool play_planned_pass(ActionContext& context);

}  // namespace cls::proxy
