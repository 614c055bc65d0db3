// A player of the mock Playmaker's simple team.
#pragma once

#include "proxy/planner/action_context.h"

namespace cls::training {

/// One decision between proxy::begin_decision() and proxy::finish_decision().
void play_as_simple_team(proxy::ActionContext& context);

}  // namespace cls::training
