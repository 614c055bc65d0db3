// The simple team with the ball at its feet.
#pragma once

#include "mock-server/simple_team/action_list.h"
#include "mock-server/simple_team/situation.h"

namespace cls::mock_server {

/// Shoots, passes, dribbles or clears; the agent can kick the ball now.
void attack(const Situation& now, ActionList& list);

/// Brings a dead ball into play by the best pass there is, or by a long ball.
void kick_dead_ball(const Situation& now, ActionList& list);

}  // namespace cls::mock_server
