// How long a random walk takes to leave an interval: the length of sequential tests.
#pragma once

namespace cls::league {

/// A random walk, per sample.
struct Walk {
  double drift = 0.0;
  double diffusion = 0.0;  ///< variance of a step
};

/// The log-likelihood ratio of a mean of `mean1` against one of `mean0`, if the samples have the
/// mean `mean` and this variance.
Walk walk_of_mean(double mean, double variance, double mean0, double mean1);

/// The average number of steps until a walk that stands at `position` leaves `lower` to `upper`:
/// the exit time of a Brownian motion; 0 outside.
double exit_time(double position, double lower, double upper, const Walk& walk);

}  // namespace cls::league
