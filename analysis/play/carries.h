// Carries, dribbles and take-ons.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Two consecutive touches of one player within a live phase (docs/spec/match-statistics.md 3.1).
struct Carry {
  std::uint32_t touch = 0;  ///< index of the first into Flow::touches
  std::int8_t slot = kNoPlayer;
  soccer::Vec2 from{};  ///< contact points, as the player's team sees the pitch
  soccer::Vec2 to{};
  bool dribble = false;  ///< the player dashed and moved at least 1 m
  int passed = 0;        ///< opponents ahead within 3 m, then behind the ball

  std::size_t team() const { return team_of(slot); }
  double distance() const { return soccer::distance(from, to); }
  double gain() const { return to.x - from.x; }
};

std::vector<Carry> find_carries(const Flow& flow);

}  // namespace cls::analysis
