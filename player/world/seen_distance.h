// Inverts the quantization of distances in see messages: range of true distances per printed value.
#pragma once

#include <cstddef>
#include <vector>

#include "player/world/vocabulary.h"

namespace cls::player {

/// Range in meters.
struct DistanceRange {
  double low = 0.0;
  double high = 0.0;

  double middle() const { return 0.5 * (low + high); }
};

/// Variance of a distance with Gaussian noise (docs/spec/simulation-model.md 7.4), from the rates
/// of the observer's type and the distances to the object from the observer and from the focus
/// point. Never zero, so that it can weigh observations: printed distances have six digits.
double gaussian_distance_variance(double rate, double distance, double focus_rate,
                                  double focus_distance);

/// Inverse of the server's quantization (logarithm to a multiple of `step`, the result to 0.1 m;
/// docs/spec/simulation-model.md 7.4) for one step, as a table by printed value.
class DistanceTable {
 public:
  explicit DistanceTable(double step);

  double step() const { return step_; }

  /// The range for a focus point at the observer. A value the server never prints maps to the
  /// nearest one it prints.
  DistanceRange range(double printed) const;

  /// The range for a focus point at `focus_distance` +- `focus_error` from the object.
  DistanceRange range(double printed, double focus_distance, double focus_error) const;

  /// The range for a focus point at `focus` and an object on the ray from `eye` along the unit
  /// vector `direction`: the focus distance depends on the unknown distance.
  DistanceRange range_along(double printed, Vec2 eye, Vec2 direction, Vec2 focus) const;

 private:
  /// One quantization step: the distance it rounds to, and its ends.
  struct Step {
    double rounded = 0.0;
    DistanceRange ends;
  };
  /// The first step that ends at or beyond a distance; the last one for larger distances.
  std::size_t step_index(double distance) const;
  /// As step_index(), if the index is known to lie between `from` and `to`.
  std::size_t find_step(double distance, std::size_t from, std::size_t to) const;
  DistanceRange rounding_errors(DistanceRange distance) const;

  double step_;
  double share_;  ///< a correction is at most half of this share of its distance
  std::vector<DistanceRange> by_tenths_;
  std::vector<Step> steps_;               ///< ascending; empty without quantization
  std::vector<std::size_t> first_steps_;  ///< step_index() at the begin of each cell
};

}  // namespace cls::player
