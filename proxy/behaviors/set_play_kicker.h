// The one who brings our dead ball into play.
#pragma once

#include "proxy/planner/action_context.h"

namespace cls::proxy {

/// Number of ours who is to kick the dead ball: of the two whose places are nearest to it the
/// clearly nearer one, else the one who is nearer now. 0 when nobody is known.
int set_play_kicker(const WorldModel& world);

/// Goes behind the ball, waits for the others, kicks.
bool kick_set_play(ActionContext& context);

}  // namespace cls::proxy
