// Mean and variance of a normal distribution cut to an interval.
#pragma once

namespace cls::proxy {

struct Moments {
  double mean = 0.0;
  double variance = 1.0;
};

/// A normal distribution with that mean and variance (> 0), conditioned on lying in [low, high]
/// (low < high). Right to about 1e-4 of the standard deviation in the bulk and to a few percent
/// of the result's own width far out in a tail; the result always lies inside the interval and is
/// never wider than what it came from. Same bits everywhere.
Moments truncated(Moments normal, double low, double high);

}  // namespace cls::proxy
