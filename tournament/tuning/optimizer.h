// Search for the best point when each value is noisy: generations of points to try.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "soccer/random.h"
#include "tournament/tuning/parameter.h"

namespace cls::tournament {

/// The unit cube in which an optimizer searches.
struct SearchSpace {
  Point start;
  Point steps;      ///< first standard deviation of each coordinate
  Point min_steps;  ///< trial points differ by at least this, so that integers still change
  std::function<bool(const Point&)> valid = [](const Point&) { return true; };
};

/// Asks for the value of points, from the current best guess on. A pure function of its arguments
/// and of the values so far, so a tuning resumes by repeating them.
class Optimizer {
 public:
  virtual ~Optimizer() = default;

  /// The points of the next generation; all are valid and inside the cube.
  virtual std::vector<Point> ask() = 0;

  /// Their values, higher is better. Follows each ask().
  virtual void tell(const std::vector<double>& values) = 0;

  /// The current best guess: it averages over the noise of the trial points.
  virtual Point best() const = 0;

  /// The current standard deviation of the trial points, per coordinate.
  virtual Point spread() const = 0;
};

/// CMA-ES: a population whose covariance adapts. Hansen, "The CMA Evolution Strategy: A Tutorial"
/// (2016). `population` 0: 4 + 3 ln(dimensions).
std::unique_ptr<Optimizer> make_cma_es(const SearchSpace& space, int population,
                                       std::uint64_t seed);

/// Simultaneous perturbation (SPSA): two points on opposite sides of the best guess; it moves
/// towards the better one. Spall, IEEE TAES 34 (1998), with his exponents of the gains. Values are
/// assumed between 0 and 1: a difference of 1 moves the guess by one step at the beginning.
/// `generations` is the expected number.
std::unique_ptr<Optimizer> make_spsa(const SearchSpace& space, int generations, std::uint64_t seed);

}  // namespace cls::tournament
