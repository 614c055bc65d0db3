// Finds the strongest push of the ball. Of two contacts in one cycle the stronger counts as the
// last touch (docs/spec/simulation-model.md 9.9), but a log shows only the sum of the pushes and
// their noise.
#pragma once

#include <optional>
#include <vector>

#include "simulator/world/world.h"

namespace cls::simulator {

/// Acceleration of the ball by one kick or tackle.
struct BallPush {
  Slot slot = kNoPlayer;
  Vec2 acceleration;       ///< without noise
  double noise_max = 0.0;  ///< radius of the noise
};

/// Players whose push may have been the strongest, in the order of the commands: one if noise
/// cannot change the order, none without pushes. `world` is the world before the step.
/// `displacement` is the recorded motion of the ball, if nothing else deflected, stopped or placed
/// it.
std::vector<Slot> strongest_pushers(const World& world, const std::vector<BallPush>& pushes,
                                    std::optional<Vec2> displacement);

}  // namespace cls::simulator
