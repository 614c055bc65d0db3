// Builds the table from the rounding itself, and undoes the correction a focus point brings.
#include "proxy/world/seen_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "soccer/math.h"

namespace cls::proxy {
namespace {

namespace math = soccer::math;

// Farther than anything on the pitch, in tenths of a metre, rounding included.
constexpr int kTenths = 1400;

/// Twice the correction that the log rounding of `distance` brings: distance - rounded.
double rounding_error(double distance, double step) {
  const double value = distance + math::kEps;
  return distance - math::exp(math::quantize(math::log(value), step));
}

}  // namespace

DistanceTable::DistanceTable(double step) : step_(step), by_tenths_(kTenths + 1) {
  if (step <= math::kEps) {  // no rounding of the logarithm
    for (int i = 0; i <= kTenths; ++i) {
      by_tenths_[static_cast<std::size_t>(i)] = {std::max(0.0, 0.1 * i - 0.05), 0.1 * i + 0.05};
    }
    return;
  }
  for (DistanceRange& range : by_tenths_) range = {-1.0, -1.0};
  const int last = static_cast<int>(std::ceil(math::log(0.1 * kTenths) / step));
  const int first = static_cast<int>(std::floor(math::log(1e-3) / step));
  for (int k = first; k <= last; ++k) {
    const long tenths = std::lround(math::quantize(math::exp(k * step), 0.1) * 10.0);
    if (tenths > kTenths) break;
    DistanceRange& range = by_tenths_[static_cast<std::size_t>(tenths)];
    if (range.high < 0.0) range.low = math::exp((k - 0.5) * step);
    range.high = math::exp((k + 0.5) * step);
  }
  by_tenths_[0].low = 0.0;
  // Values in the gaps are never printed; give them what lies around them.
  double below = by_tenths_[0].high;
  for (DistanceRange& range : by_tenths_) {
    if (range.high >= 0.0) {
      below = range.high;
    } else {
      range = {below * math::exp(-step), below * math::exp(step)};
    }
  }
}

DistanceRange DistanceTable::range(double printed) const {
  const double tenths = std::clamp(std::rint(printed * 10.0), 0.0, static_cast<double>(kTenths));
  return by_tenths_[static_cast<std::size_t>(tenths)];
}

DistanceRange DistanceTable::range(double printed, double focus_distance,
                                   double focus_error) const {
  // printed = d - (focus correction) - (own correction), each half a rounding error; the middle of
  // what is left is within 0.05 of (d + rounded d) / 2.
  const double near = rounding_error(std::max(0.0, focus_distance - focus_error), step_);
  const double middle = rounding_error(focus_distance, step_);
  const double far = rounding_error(focus_distance + focus_error, step_);
  const double low = printed - 0.05 + 0.5 * std::min({near, middle, far});
  const double high = printed + 0.05 + 0.5 * std::max({near, middle, far});
  DistanceRange found{-1.0, -1.0};
  const double reach = std::max(high, 0.05);
  const int last = static_cast<int>(std::ceil(math::log(reach) / step_ + 1.0));
  const int first = static_cast<int>(std::floor(math::log(std::max(0.02, low)) / step_ - 1.0));
  for (int k = first; k <= last; ++k) {
    const double rounded = math::exp(k * step_);
    const double from = std::max(2.0 * low - rounded, math::exp((k - 0.5) * step_));
    const double to = std::min(2.0 * high - rounded, math::exp((k + 0.5) * step_));
    if (from > to) continue;
    if (found.high < 0.0) found.low = from;
    found.high = to;
  }
  if (found.high >= 0.0) return {low <= 0.0 ? 0.0 : found.low, found.high};
  return {std::max(0.0, printed - 0.05 - 0.5 * step_ * printed),
          printed + 0.05 + 0.5 * step_ * printed};
}

DistanceRange DistanceTable::range_along(double printed, soccer::Vec2 eye, soccer::Vec2 direction,
                                         soccer::Vec2 focus) const {
  // The server's own rounding, tried at points of the ray that the plain range would allow and a
  // little beyond; what prints the same is feasible. Points are denser than the result matters.
  const DistanceRange plain = range(printed);
  const double reach = 0.6 * (plain.high - plain.low) + 0.1;
  const double from = std::max(0.0, plain.middle() - 2.0 * reach);
  const double to = plain.middle() + 2.0 * reach;
  constexpr int kPoints = 96;
  DistanceRange found{-1.0, -1.0};
  const double gap = (to - from) / kPoints;
  for (int i = 0; i <= kPoints; ++i) {
    const double d = from + gap * i;
    const double f = soccer::distance(eye + direction * d, focus);
    const double seen =
        std::max(0.0, d - 0.5 * (rounding_error(f, step_) + rounding_error(d, step_)));
    if (std::fabs(seen - printed) > 0.05 + gap) continue;
    if (found.high < 0.0) found.low = d;
    found.high = d;
  }
  return found.high < 0.0 ? plain : DistanceRange{std::max(0.0, found.low - gap), found.high + gap};
}

}  // namespace cls::proxy
