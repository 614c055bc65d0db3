// Completing a world model whose agent does not decide by the skills of matches.
#pragma once

#include "player/world/world_model.h"

namespace cls::player {

/// As update_derived(), but the agent's own intercept plans end with the cycle in which another
/// player gets the ball. That is all of them that looking and the team lines depend on, and a
/// fraction of the work.
void update_derived_for_looking(WorldModel& world);

}  // namespace cls::player
