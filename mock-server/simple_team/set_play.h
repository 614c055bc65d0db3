// The simple team at dead balls.
#pragma once

#include "mock-server/simple_team/action_list.h"
#include "mock-server/simple_team/situation.h"

namespace cls::mock_server {

/// The nearest player fetches our dead ball and kicks it; the others take their places. Theirs:
/// everybody takes its place.
void play_set_play(const Situation& now, ActionList& list);

}  // namespace cls::mock_server
