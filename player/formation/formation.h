// A formation: home positions of eleven players as a function of the ball position.
#pragma once

#include <array>
#include <vector>

#include "base/result.h"
#include "player/formation/triangulation.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::player {

/// Positions by unum - 1; meters, own team attacks +x.
using TeamPoints = std::array<Vec2, soccer::kPlayersPerTeam>;

struct FormationSample {
  Vec2 ball;
  TeamPoints players;
};

class Formation {
 public:
  /// Fails without samples, and when two samples have the ball within 5 cm.
  static base::Result<Formation> make(std::vector<FormationSample> samples);

  /// Interpolates linearly within the triangle of samples around the ball. A ball outside all
  /// triangles is moved to the nearest point of their hull. A single sample applies everywhere.
  TeamPoints positions(Vec2 ball) const;

  const std::vector<FormationSample>& samples() const { return samples_; }

 private:
  Formation() = default;
  TeamPoints interpolate(const std::array<std::size_t, 3>& corners,
                         const std::array<double, 3>& weights) const;
  TeamPoints nearest_on_hull(Vec2 ball) const;

  std::vector<FormationSample> samples_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> hull_;  ///< edges of exactly one triangle, or the chain
};

}  // namespace cls::player
