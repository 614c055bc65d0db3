// Does a tackle hurt an opponent, and does the referee see it (4.15)?
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

/// Judges a tackle that moved the ball. With `foul` (meant to be one) every opponent at the ball is
/// frozen for foul_cycles, seen or not.
FoulCall detect_foul(World& world, const Player& tackler, bool foul);

}  // namespace cls::simulator
