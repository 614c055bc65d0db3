// Where both teams must stand at a kick of the shoot-out.
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

bool is_team_placed(const World& world, Side side);

/// Puts the team's players where they must be; velocities stay.
void place_team(World& world, Side side);

}  // namespace cls::simulator
