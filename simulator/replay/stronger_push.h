// Who pushed the ball hardest: of two contacts in one cycle the stronger counts as the last touch
// (9.9), and a record shows only what their pushes, noise included, came to together.
#pragma once

#include <optional>
#include <vector>

#include "simulator/world/world.h"

namespace cls::simulator {

/// What one kick or tackle gives the ball.
struct BallPush {
  Slot slot = kNobody;
  Vec2 acceleration;       ///< without noise
  double noise_max = 0.0;  ///< radius of its noise
};

/// Those whose push may have been the strongest, in the order of the commands; one if noise cannot
/// have changed it, none if nobody pushed. `world` is that before the step; `way` is how far the
/// ball came if nothing else turned, stopped or placed it.
std::vector<Slot> strongest_pushers(const World& world, const std::vector<BallPush>& pushes,
                                    std::optional<Vec2> way);

}  // namespace cls::simulator
