// The simple team's field players without the ball.
#pragma once

#include "mock-server/simple_team/action_list.h"
#include "mock-server/simple_team/situation.h"

namespace cls::mock_server {

/// Goes for the ball when nobody of ours is quicker, tackles, blocks, or takes its place.
void play_without_ball(const Situation& now, ActionList& list);

/// Takes the own place for the present ball.
void go_home(const Situation& now, ActionList& list);

}  // namespace cls::mock_server
