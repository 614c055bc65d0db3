// Detection of fouls by tackles (docs/spec/simulation-model.md 4.15).
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

/// Returns the referee's call for a tackle that moved the ball. With `foul` (an intentional foul)
/// every opponent that could kick the ball is blocked for foul_cycles, detected or not.
FoulCall detect_foul(World& world, const Player& tackler, bool foul);

}  // namespace cls::simulator
