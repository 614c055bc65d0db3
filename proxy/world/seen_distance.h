// The true distances a printed distance of a see message can stand for.
#pragma once

#include <cstddef>
#include <vector>

#include "soccer/geometry.h"

namespace cls::proxy {

/// A range of metres.
struct DistanceRange {
  double low = 0.0;
  double high = 0.0;

  double middle() const { return 0.5 * (low + high); }
};

/// Inverse of the server's two-step rounding (logarithm to a multiple of `step`, the result to
/// 0.1 m; simulation model 7.4) for one step, as a table by printed value.
class DistanceTable {
 public:
  explicit DistanceTable(double step);

  double step() const { return step_; }

  /// Observer and focus point coincide. A value the server never prints gives the range around the
  /// nearest one it does.
  DistanceRange range(double printed) const;

  /// The focus point is `focus_distance` away from the object, give or take `focus_error`.
  DistanceRange range(double printed, double focus_distance, double focus_error) const;

  /// The focus point is at `focus`, the object somewhere on the ray from `eye` along the unit
  /// vector `direction`: the distance from the focus point changes with the one looked for.
  DistanceRange range_along(double printed, soccer::Vec2 eye, soccer::Vec2 direction,
                            soccer::Vec2 focus) const;

 private:
  /// A step of the logarithm: the distance all in it are rounded to, and its ends.
  struct Step {
    double rounded = 0.0;
    DistanceRange ends;
  };
  std::size_t step_index(double distance) const;
  DistanceRange rounding_errors(DistanceRange distance) const;

  double step_;
  std::vector<DistanceRange> by_tenths_;
  std::vector<Step> steps_;  ///< ascending; empty when nothing is rounded
  int first_step_ = 0;       ///< multiple of step_ that steps_ begins with
};

}  // namespace cls::proxy
