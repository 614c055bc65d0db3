// The part of a dash that waits for the step (4.3).
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

/// Turns what the legs were told into acceleration, rotation and spent stamina. Nothing if neither
/// leg dashes.
void use_legs(World& world, Player& player);

}  // namespace cls::simulator
