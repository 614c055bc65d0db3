// Where each of our players belongs at the moment: the built-in formation.
#pragma once

#include <array>

#include "proxy/world_model.h"

namespace cls::proxy {

/// Points by unum - 1, own team attacking +x: State.helios_home_positions. Depends on the mode and
/// on where the ball will be reached first; respects the own half before kick-off and the offside
/// line.
std::array<soccer::Vec2, soccer::kPlayersPerTeam> home_positions(const WorldModel& world);

}  // namespace cls::proxy
