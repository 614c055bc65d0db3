// Where both teams must stand at a kick of the shoot-out.
#pragma once

#include "simulator/world.h"

namespace cls::simulator {

bool is_taker_team_placed(const World& world);
bool is_defending_team_placed(const World& world);

// Puts the team's players where they must be; velocities stay.
void place_taker_team(World& world);
void place_defending_team(World& world);

}  // namespace cls::simulator
