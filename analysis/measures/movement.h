// How far and how fast players ran.
#pragma once

#include <array>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Frames by speed in shares of the player type's top speed.
enum class SpeedBand : unsigned char { kStand, kJog, kRun, kSprint };  // up to 20, 60, 85 %, above
constexpr std::size_t kSpeedBandCount = 4;

struct Movement {
  double live_distance = 0.0;                   ///< metres in live frames
  double other_distance = 0.0;                  ///< metres in all others
  double top_speed = 0.0;                       ///< metres per cycle, live
  std::array<int, kSpeedBandCount> bands = {};  ///< live frames

  double distance() const { return live_distance + other_distance; }
};

/// Steps beyond 1.5 times the top speed are placements, not runs, and left out; so are steps in
/// which a player connects or leaves.
PerPlayer<Movement> movement_of(const Flow& flow);

}  // namespace cls::analysis
