// Lines across the pitch that the last players of a team draw.
#pragma once

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Fills `world.lines` (proxy behaviour 3.7) from players, ball and intercept table.
void draw_lines(WorldModel& world);

}  // namespace cls::proxy
