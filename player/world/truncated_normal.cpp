// Tables of the normal density and distribution, and the three regimes of a truncated normal.
#include "player/world/gaussian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "player/world/vocabulary.h"

namespace cls::player {
namespace {

constexpr double kTableEnd = 6.0;
constexpr int kPerUnit = 32;
constexpr std::size_t kTableSize = static_cast<std::size_t>(kTableEnd) * kPerUnit;

/// Cubic polynomial; coefficients by power.
struct Cubic {
  double c0 = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0;

  /// With these values and slopes at 0 and 1 (Hermite interpolation).
  static Cubic between(double v0, double slope0, double v1, double slope1) {
    const double rise = v1 - v0;
    return {v0, slope0, 3.0 * rise - 2.0 * slope0 - slope1, slope0 + slope1 - 2.0 * rise};
  }
  double at(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
};

/// Density and distribution of the standard normal as cubics, cell by cell from 0 to kTableEnd.
struct NormalTable {
  struct Cell {
    Cubic density;
    Cubic from_zero;  ///< probability of (0, x)
  };
  std::array<Cell, kTableSize> cells{};

  NormalTable() {
    const double scale = 1.0 / std::sqrt(2.0 * math::kPi);
    const auto phi = [scale](double x) { return scale * math::exp(-0.5 * x * x); };
    constexpr double h = 1.0 / kPerUnit;
    double sum = 0.0;

    for (std::size_t i = 0; i < kTableSize; ++i) {
      const double x = static_cast<double>(i) * h;
      const double d0 = phi(x);
      const double d1 = phi(x + h);
      // Simpson's rule; its error is far below 1e-10 at this width.
      const double next = sum + h / 6.0 * (d0 + 4.0 * phi(x + h / 2) + d1);
      // The derivative of the density is -x times it, that of the distribution is the density.
      cells[i] = {Cubic::between(d0, -h * x * d0, d1, -h * (x + h) * d1),
                  Cubic::between(sum, h * d0, next, h * d1)};
      sum = next;
    }
  }
};

struct DensityAndProbability {
  double density;
  double from_zero;  ///< probability of (0, x), negative for negative x
};

inline DensityAndProbability normal_at(const NormalTable& table, double x) {
  const double a = std::fabs(x);
  if (a >= kTableEnd) return {0.0, std::copysign(0.5, x)};

  const double scaled = a * kPerUnit;
  const auto i = static_cast<std::size_t>(scaled);
  const double t = scaled - static_cast<double>(i);
  const NormalTable::Cell& cell = table.cells[i];
  return {cell.density.at(t), std::copysign(cell.from_zero.at(t), x)};
}

/// Density proportional to exp(-rate * t) on [0, width], rate > 0.
Moments truncated_exponential(double rate, double width) {
  const double k = rate * width;
  if (k > 40.0) return {1.0 / rate, 1.0 / (rate * rate)};
  const double e = math::exp(k);
  const double rest = width / (e - 1.0);
  return {1.0 / rate - rest, 1.0 / (rate * rate) - e * rest * rest};
}

/// Interval so narrow that the density is linear in it; standard units.
Moments narrow(double middle, double width) {
  const double w2 = width * width;
  return {middle - middle * w2 / 12.0,
          w2 / 12.0 * (1.0 - w2 / 60.0 * (1.0 + 2.0 * middle * middle))};
}

/// Interval [a, b] far in the upper tail; standard units.
Moments far_tail(double a, double b) {
  const double rate = a + 2.0 / a;  // the slope of the log density a little inside the edge
  const Moments tail = truncated_exponential(rate, b - a);
  return {a + tail.mean, tail.variance};
}

/// Standard normal truncated to [a, b].
Moments standard(double a, double b) {
  const double width = b - a;
  const double middle = 0.5 * (a + b);
  if (width * std::max(1.0, std::fabs(middle)) < 0.25) return narrow(middle, width);

  constexpr double kTail = 4.5;
  if (a > kTail) return far_tail(a, b);
  if (b < -kTail) {
    const Moments mirrored = far_tail(-b, -a);
    return {-mirrored.mean, mirrored.variance};
  }

  static const NormalTable table;
  const DensityAndProbability low = normal_at(table, a);
  const DensityAndProbability high = normal_at(table, b);
  const double inverse = 1.0 / (high.from_zero - low.from_zero);

  const double mean = (low.density - high.density) * inverse;
  // The density is 0 beyond the table; the edge need not be finite.
  const double a_term = std::clamp(a, -kTableEnd, kTableEnd) * low.density;
  const double b_term = std::clamp(b, -kTableEnd, kTableEnd) * high.density;
  return {mean, 1.0 + (a_term - b_term) * inverse - mean * mean};
}

}  // namespace

Moments truncated(Moments normal, double low, double high) {
  const double deviation = std::sqrt(normal.variance);
  const double inverse = 1.0 / deviation;
  const double a = (low - normal.mean) * inverse;
  const double b = (high - normal.mean) * inverse;

  if (!(a <= b)) return normal;  // numbers of a faulty server: no interval, or none that is finite
  const Moments standardized = standard(a, b);
  const double mean = std::clamp(normal.mean + deviation * standardized.mean, low, high);
  const double width = high - low;

  // Bounds: an interval's maximum variance, and more than zero.
  const double variance = std::clamp(standardized.variance, 1e-9, 1.0) * normal.variance;
  return {mean, std::clamp(variance, 1e-12 * width * width, width * width / 4.0)};
}

}  // namespace cls::player
