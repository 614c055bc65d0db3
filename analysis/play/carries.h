// Going on with the ball: carries, dribbles, take-ons.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Two touches of one player in a row, within a live phase (match-statistics 3.1).
struct Carry {
  std::uint32_t touch = 0;  ///< index of the first into Flow::touches
  std::int8_t slot = kNobody;
  soccer::Vec2 from;  ///< contact points, as the player's team sees them
  soccer::Vec2 to;
  bool dribble = false;  ///< he ran, and got 1 m further at least
  int passed = 0;        ///< opponents who stood up to 3 m in front of him and are behind the ball

  double distance() const { return soccer::distance(from, to); }
  double gain() const { return to.x - from.x; }
};

std::vector<Carry> carries_of(const Flow& flow);

}  // namespace cls::analysis
