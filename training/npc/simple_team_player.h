// A player of the mock Playmaker's simple team.
#pragma once

#include "player/planner/action_context.h"

namespace cls::training {

/// One decision between player::begin_decision() and player::finish_decision().
void play_as_simple_team(player::ActionContext& context);

}  // namespace cls::training
