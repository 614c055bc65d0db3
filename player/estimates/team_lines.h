// Defense lines and the offside line.
#pragma once

#include "player/world/world_model.h"

namespace cls::player {

/// Sets `world.lines` (docs/spec/proxy-behavior.md 3.7) from players, ball and intercept table.
void update_team_lines(WorldModel& world);

}  // namespace cls::player
