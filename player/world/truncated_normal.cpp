// Tables of the normal density and distribution, and the three regimes of a truncated normal.
#include "player/world/truncated_normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "soccer/math.h"

namespace cls::player {
namespace {

namespace math = soccer::math;

constexpr double kTableEnd = 6.0;
constexpr int kPerUnit = 64;
constexpr std::size_t kTableSize = static_cast<std::size_t>(kTableEnd) * kPerUnit + 2;

struct NormalTable {
  std::array<double, kTableSize> density{};
  std::array<double, kTableSize> upper{};  ///< probability of (0, x)

  NormalTable() {
    const double scale = 1.0 / std::sqrt(2.0 * math::kPi);
    const auto phi = [scale](double x) { return scale * math::exp(-0.5 * x * x); };
    double sum = 0.0;

    for (std::size_t i = 0; i < kTableSize; ++i) {
      const double x = static_cast<double>(i) / kPerUnit;
      density[i] = phi(x);
      upper[i] = sum;
      // Simpson's rule over the next cell; its error is far below 1e-12 at this width.
      const double h = 1.0 / kPerUnit;
      sum += h / 6.0 * (phi(x) + 4.0 * phi(x + h / 2) + phi(x + h));
    }
  }
};

struct DensityAndProbability {
  double density;
  double from_zero;  ///< probability of (0, x), negative for negative x
};

DensityAndProbability normal_at(double x) {
  static const NormalTable table;
  const double a = std::fabs(x);
  if (a >= kTableEnd) return {0.0, x < 0 ? -0.5 : 0.5};

  const double scaled = a * kPerUnit;
  const auto i = static_cast<std::size_t>(scaled);
  const double t = scaled - static_cast<double>(i);
  const double h = 1.0 / kPerUnit;

  // Cubic Hermite interpolation: the derivative of the density is -x times it, that of the
  // distribution is the density.
  const double t2 = t * t;
  const double t3 = t2 * t;
  const double h00 = 2 * t3 - 3 * t2 + 1;
  const double h10 = t3 - 2 * t2 + t;
  const double h01 = 1 - h00;
  const double h11 = t3 - t2;

  const double d0 = table.density[i];
  const double d1 = table.density[i + 1];
  const double x0 = static_cast<double>(i) * h;
  const double x1 = x0 + h;

  const double density = h00 * d0 + h01 * d1 - h * (h10 * x0 * d0 + h11 * x1 * d1);
  const double probability =
      h00 * table.upper[i] + h01 * table.upper[i + 1] + h * (h10 * d0 + h11 * d1);
  return {density, x < 0 ? -probability : probability};
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

/// Standard normal truncated to [a, b].
Moments standard(double a, double b) {
  if (a + b < 0.0) {
    const Moments mirrored = standard(-b, -a);
    return {-mirrored.mean, mirrored.variance};
  }

  const double width = b - a;
  const double middle = 0.5 * (a + b);
  if (width * std::max(1.0, middle) < 0.25) return narrow(middle, width);

  if (a > 4.5) {
    const double rate = a + 2.0 / a;  // the slope of the log density a little inside the edge
    const Moments tail = truncated_exponential(rate, width);
    return {a + tail.mean, tail.variance};
  }

  const DensityAndProbability low = normal_at(a);
  const DensityAndProbability high = normal_at(b);
  const double probability = high.from_zero - low.from_zero;

  const double mean = (low.density - high.density) / probability;
  const double a_term = std::fabs(a) < kTableEnd ? a * low.density : 0.0;
  const double b_term = std::fabs(b) < kTableEnd ? b * high.density : 0.0;
  return {mean, 1.0 + (a_term - b_term) / probability - mean * mean};
}

}  // namespace

Moments truncated(Moments normal, double low, double high) {
  const double deviation = std::sqrt(normal.variance);
  const double a = (low - normal.mean) / deviation;
  const double b = (high - normal.mean) / deviation;

  if (!(a <= b)) return normal;  // numbers of a faulty server: no interval, or none that is finite
  const Moments standardized = standard(a, b);
  const double mean = std::clamp(normal.mean + deviation * standardized.mean, low, high);
  const double width = high - low;

  // Bounds: an interval's maximum variance, and more than zero.
  const double variance = std::clamp(standardized.variance, 1e-9, 1.0) * normal.variance;
  return {mean, std::clamp(variance, 1e-12 * width * width, width * width / 4.0)};
}

}  // namespace cls::player
