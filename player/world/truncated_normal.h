// Mean and variance of a truncated normal distribution.
#pragma once

namespace cls::player {

struct Moments {
  double mean = 0.0;
  double variance = 1.0;
};

/// Moments of a normal distribution (variance > 0) truncated to [low, high] (low < high). Accurate
/// to about 1e-4 standard deviations in the bulk, and a few percent of the result's deviation far
/// in a tail. The mean is inside the interval, the variance not above the input. Same bits on every
/// platform.
Moments truncated(Moments normal, double low, double high);

}  // namespace cls::player
