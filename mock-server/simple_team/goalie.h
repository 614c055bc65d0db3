// The simple team's goalie.
#pragma once

#include "mock-server/simple_team/action_list.h"
#include "mock-server/simple_team/situation.h"

namespace cls::mock_server {

/// Catches, comes out, clears, or keeps the angle small.
void keep_goal(const Situation& now, ActionList& list);

/// With the ball in hand after a catch.
void bring_out_caught_ball(const Situation& now, ActionList& list);

}  // namespace cls::mock_server
