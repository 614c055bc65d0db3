// Formulas of docs/spec/match-statistics.md 8.3.
#include "league/rating/exit_time.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cls::league {

Walk walk_of_mean(double mean, double variance, double mean0, double mean1) {
  constexpr double kMinVariance = 1e-3;  // equal results so far
  const double gap = mean1 - mean0;
  const double spread = std::max(variance, kMinVariance);
  return {gap / spread * (mean - (mean0 + mean1) / 2), gap * gap / spread};
}

double exit_time(double position, double lower, double upper, const Walk& walk) {
  constexpr double kNoDrift = 1e-9;
  double below = position - lower;
  double above = upper - position;
  if (below <= 0 || above <= 0) return 0.0;
  double drift = walk.drift;
  if (std::abs(drift) < kNoDrift * walk.diffusion) return below * above / walk.diffusion;
  if (drift < 0) {  // mirrored, so that no exponential overflows
    drift = -drift;
    std::swap(below, above);
  }
  const double rate = 2 * drift / walk.diffusion;
  const double reaches_upper =
      (1 - std::exp(-rate * below)) / (1 - std::exp(-rate * (below + above)));
  return ((below + above) * reaches_upper - below) / drift;
}

}  // namespace cls::league
