// Where eleven players belong for each place of the ball: samples, and what lies between them.
#pragma once

#include <array>
#include <vector>

#include "base/result.h"
#include "proxy/formation/triangulation.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::proxy {

/// Points by unum - 1; metres, own team attacking +x.
using TeamPoints = std::array<soccer::Vec2, soccer::kPlayersPerTeam>;

struct FormationSample {
  soccer::Vec2 ball;
  TeamPoints players;
};

class Formation {
 public:
  /// Not ok without samples, and when two of them have the ball at the same place (within 5 cm).
  static base::Result<Formation> make(std::vector<FormationSample> samples);

  /// Linear within the triangle of samples around the ball; a ball outside all triangles counts as
  /// being at the nearest point of their hull. One sample alone is the same everywhere.
  TeamPoints positions(soccer::Vec2 ball) const;

  const std::vector<FormationSample>& samples() const { return samples_; }

 private:
  Formation() = default;
  TeamPoints between(const std::array<std::size_t, 3>& corners,
                     const std::array<double, 3>& weights) const;
  TeamPoints at_hull(soccer::Vec2 ball) const;

  std::vector<FormationSample> samples_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<std::size_t, 2>> hull_;  ///< edges of one triangle only, or the chain
};

}  // namespace cls::proxy
