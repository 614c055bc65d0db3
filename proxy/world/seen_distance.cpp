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

// Nearer than anything that is ever looked at for long.
constexpr double kNearest = 1e-3;

}  // namespace

DistanceTable::DistanceTable(double step) : step_(step), by_tenths_(kTenths + 1) {
  fill_powers();
  if (step <= math::kEps) {  // no rounding of the logarithm
    for (int i = 0; i <= kTenths; ++i) {
      by_tenths_[static_cast<std::size_t>(i)] = {std::max(0.0, 0.1 * i - 0.05), 0.1 * i + 0.05};
    }
    return;
  }
  for (DistanceRange& range : by_tenths_) range = {-1.0, -1.0};
  const int last = static_cast<int>(std::ceil(math::log(0.1 * kTenths) / step));
  const int first = static_cast<int>(std::floor(math::log(kNearest) / step));
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

void DistanceTable::fill_powers() {
  if (step_ <= math::kEps) return;
  first_half_step_ = 2 * static_cast<int>(std::floor(math::log(kNearest) / step_)) - 1;
  const int last = 2 * static_cast<int>(std::ceil(math::log(0.1 * kTenths) / step_)) + 1;
  for (int i = first_half_step_; i <= last; ++i) powers_.push_back(math::exp(0.5 * i * step_));
}

double DistanceTable::power(int half_steps) const {
  const int i = half_steps - first_half_step_;
  const bool known = i >= 0 && static_cast<std::size_t>(i) < powers_.size();
  return known ? powers_[static_cast<std::size_t>(i)] : math::exp(0.5 * half_steps * step_);
}

double DistanceTable::rounding_error(double distance, std::size_t& hint) const {
  const double value = distance + math::kEps;
  if (powers_.empty() || value <= powers_.front() || value >= powers_.back()) {
    return distance - math::exp(math::quantize(math::log(value), step_));
  }
  // Rounding turns at the powers of an odd number of half steps; they have the even indices.
  if (hint == 0) {
    const auto above = std::upper_bound(powers_.begin(), powers_.end(), value);
    hint = static_cast<std::size_t>(above - powers_.begin() - 1) / 2 * 2 + 1;
  }
  while (value > powers_[hint + 1]) hint += 2;
  while (value < powers_[hint - 1]) hint -= 2;
  return distance - powers_[hint];
}

DistanceRange DistanceTable::range(double printed) const {
  const double tenths = std::clamp(std::rint(printed * 10.0), 0.0, static_cast<double>(kTenths));
  return by_tenths_[static_cast<std::size_t>(tenths)];
}

DistanceRange DistanceTable::range(double printed, double focus_distance,
                                   double focus_error) const {
  // printed = d - (focus correction) - (own correction), each half a rounding error; the middle of
  // what is left is within 0.05 of (d + rounded d) / 2.
  std::size_t hint = 0;
  const double near = rounding_error(std::max(0.0, focus_distance - focus_error), hint);
  const double middle = rounding_error(focus_distance, hint);
  const double far = rounding_error(focus_distance + focus_error, hint);
  const double low = printed - 0.05 + 0.5 * std::min({near, middle, far});
  const double high = printed + 0.05 + 0.5 * std::max({near, middle, far});
  DistanceRange found{-1.0, -1.0};
  const double reach = std::max(high, 0.05);
  const int last = static_cast<int>(std::ceil(math::log(reach) / step_ + 1.0));
  const int first = static_cast<int>(std::floor(math::log(std::max(0.02, low)) / step_ - 1.0));
  for (int k = first; k <= last; ++k) {
    const double rounded = power(2 * k);
    const double from = std::max(2.0 * low - rounded, power(2 * k - 1));
    const double to = std::min(2.0 * high - rounded, power(2 * k + 1));
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
  std::size_t own_hint = 0;
  std::size_t focus_hint = 0;
  for (int i = 0; i <= kPoints; ++i) {
    const double d = from + gap * i;
    const double f = soccer::distance(eye + direction * d, focus);
    const double seen =
        std::max(0.0, d - 0.5 * (rounding_error(f, focus_hint) + rounding_error(d, own_hint)));
    if (std::fabs(seen - printed) > 0.05 + gap) continue;
    if (found.high < 0.0) found.low = d;
    found.high = d;
  }
  return found.high < 0.0 ? plain : DistanceRange{std::max(0.0, found.low - gap), found.high + gap};
}

}  // namespace cls::proxy
