// Builds the tables by inverting the server's rounding, and inverts the focus point correction.
#include "player/world/seen_distance.h"

#include <algorithm>
#include <cmath>

namespace cls::player {
namespace {

// Upper bound of printed distances, in tenths of a meter.
constexpr int kTenths = 1400;
// Maximum error of rounding to 0.1 m.
constexpr double kHalfTenth = 0.05;
// Searches for a step begin in cells of this size. A power of two: cells have exact ends.
constexpr double kCellsPerMeter = 8.0;
constexpr std::size_t kCells = 1200;
// Below this distance the logarithmic steps are finer than 0.1 m: no lookup.
constexpr double kFine = 0.05;

/// The ray from the observer to an object, and the focus point relative to it.
struct FocusRay {
  double foot = 0.0;    ///< point of the ray nearest to the focus point
  double height = 0.0;  ///< distance of the focus point from the ray

  double focus_distance(double d) const { return Vec2{d - foot, height}.length(); }

  /// Solves d - focus_distance(d) = value; the left side is non-decreasing.
  double at_difference(double value, double low, double high) const {
    if (low - focus_distance(low) >= value) return low;
    if (high - focus_distance(high) <= value) return high;
    const double span = foot - value;
    if (std::fabs(span) < 1e-9) return low;
    return std::clamp(0.5 * (foot * foot + height * height - value * value) / span, low, high);
  }

  /// Next distance beyond `d` at which the focus distance leaves [ends.low, ends.high].
  double leaves(double d, const DistanceRange& ends) const {
    if (d < foot) {
      if (ends.low <= height) return foot;
      return foot - std::sqrt(ends.low * ends.low - height * height);
    }
    return foot + std::sqrt(std::max(0.0, ends.high * ends.high - height * height));
  }
};

}  // namespace

double gaussian_distance_variance(double rate, double distance, double focus_rate,
                                  double focus_distance) {
  constexpr double kMinDeviation = 1e-3;
  const double deviation = rate * distance + focus_rate * focus_distance + kMinDeviation;
  return deviation * deviation;
}

DistanceTable::DistanceTable(double step)
    : step_(step), share_(math::exp(0.5 * step) - 1.0), by_tenths_(kTenths + 1) {
  constexpr double kMinStep = 1e-5;  // a smaller one changes nothing, but needs much memory
  if (step < kMinStep) {             // no rounding of the logarithm
    for (int i = 0; i <= kTenths; ++i) {
      by_tenths_[static_cast<std::size_t>(i)] = {std::max(0.0, 0.1 * i - kHalfTenth),
                                                 0.1 * i + kHalfTenth};
    }
    return;
  }

  const int first = static_cast<int>(std::floor(math::log(1e-3) / step));
  const int last = static_cast<int>(std::ceil(math::log(0.1 * kTenths + 60.0) / step));
  for (int k = first; k <= last; ++k) {
    steps_.push_back(
        {math::exp(k * step), {math::exp((k - 0.5) * step), math::exp((k + 0.5) * step)}});
  }

  for (std::size_t cell = 0; cell <= kCells; ++cell) {
    const double distance = static_cast<double>(cell) / kCellsPerMeter;
    first_steps_.push_back(find_step(distance, 0, steps_.size() - 1));
  }

  for (DistanceRange& range : by_tenths_) range = {-1.0, -1.0};
  for (const Step& s : steps_) {
    const double tenths = math::quantize(s.rounded, 0.1) * 10.0;
    if (!(tenths < kTenths + 0.5)) break;  // infinite with a large step
    DistanceRange& range = by_tenths_[static_cast<std::size_t>(std::lround(tenths))];
    if (range.high < 0.0) range.low = s.ends.low;
    range.high = s.ends.high;
  }

  by_tenths_[0].low = 0.0;
  // The server never prints values in the gaps; use the surrounding range.
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

std::size_t DistanceTable::find_step(double distance, std::size_t from, std::size_t to) const {
  const auto first = steps_.begin();
  const auto found = std::lower_bound(
      first + static_cast<std::ptrdiff_t>(from), first + static_cast<std::ptrdiff_t>(to), distance,
      [](const Step& step, double value) { return step.ends.high < value; });
  return static_cast<std::size_t>(found - first);
}

std::size_t DistanceTable::step_index(double distance) const {
  const double cells = distance > 0.0 ? distance * kCellsPerMeter : 0.0;
  if (cells >= static_cast<double>(kCells)) {
    return find_step(distance, first_steps_[kCells], steps_.size() - 1);
  }
  const auto cell = static_cast<std::size_t>(cells);
  return find_step(distance, first_steps_[cell], first_steps_[cell + 1]);
}

/// Range of (distance - rounded distance) for a distance known only as a range; the error rises
/// within a step and drops at its end.
DistanceRange DistanceTable::rounding_errors(DistanceRange distance) const {
  const std::size_t first = step_index(distance.low);
  const std::size_t last = step_index(distance.high);
  const double low = distance.low - steps_[first].rounded;
  const double high = distance.high - steps_[last].rounded;

  if (first == last) return {low, high};
  const Step& before = steps_[last - 1];
  const Step& after = steps_[last];
  return {std::min(low, after.ends.low - after.rounded),
          std::max(high, before.ends.high - before.rounded)};
}

DistanceRange DistanceTable::range(double printed, double focus_distance,
                                   double focus_error) const {
  if (steps_.empty()) return range(printed);
  // printed = d - (focus correction) - (own correction), each half a rounding error; after removing
  // the focus correction it is within 0.05 of (d + rounded d) / 2.
  const DistanceRange correction =
      rounding_errors({std::max(0.0, focus_distance - focus_error), focus_distance + focus_error});
  const double low = printed - kHalfTenth + 0.5 * correction.low;
  const double high = printed + kHalfTenth + 0.5 * correction.high;

  DistanceRange found{-1.0, -1.0};
  for (std::size_t k = step_index(low * (1.0 - step_)); k < steps_.size(); ++k) {
    const Step& s = steps_[k];
    if (s.ends.low > 2.0 * high - s.rounded) break;
    const double from = std::max(2.0 * low - s.rounded, s.ends.low);
    const double to = std::min(2.0 * high - s.rounded, s.ends.high);
    if (from > to) continue;
    if (found.high < 0.0) found.low = from;
    found.high = to;
  }

  if (found.high >= 0.0) return {low <= 0.0 ? 0.0 : found.low, found.high};
  const double half = kHalfTenth + 0.5 * step_ * printed;
  return {std::max(0.0, printed - half), printed + half};
}

DistanceRange DistanceTable::range_along(double printed, Vec2 eye, Vec2 direction,
                                         Vec2 focus) const {
  if (steps_.empty()) return range(printed);
  const Vec2 offset = focus - eye;
  const FocusRay ray{soccer::dot(offset, direction), std::fabs(soccer::cross(offset, direction))};
  const double beside = 0.5 * share_ * offset.length();
  double d = std::max(kFine, (printed - kHalfTenth - beside) / (1.0 + share_));
  const double end = (printed + kHalfTenth + beside) / (1.0 - share_);
  if (d >= end) return range(printed);

  // Piecewise: within one step of both distances the solution is one interval.
  DistanceRange found{-1.0, -1.0};
  std::size_t own = step_index(d);
  std::size_t at_focus = own;
  // step_index(), searched from the step of the piece before.
  const auto step_near = [this](double distance, std::size_t from) {
    while (from > 0 && steps_[from - 1].ends.high >= distance) --from;
    while (from + 1 < steps_.size() && steps_[from].ends.high < distance) ++from;
    return from;
  };

  constexpr int kMaxPieces = 200;
  for (int piece = 0; piece < kMaxPieces && d < end; ++piece) {
    while (own + 1 < steps_.size() && d >= steps_[own].ends.high) ++own;
    const double f = ray.focus_distance(d);
    double next = std::min(end, steps_[own].ends.high);
    double rounded = steps_[own].rounded;
    if (f >= kFine) {
      at_focus = step_near(f * (d < ray.foot ? 1.0 - 1e-9 : 1.0 + 1e-9), at_focus);
      const Step& step = steps_[at_focus];
      rounded += step.rounded;
      next = std::min(next, ray.leaves(d, step.ends));
    } else {
      rounded += f;  // its rounding error is negligible
      next = std::min(next, ray.foot + kFine);
    }

    next = std::max(next, d + 1e-6);
    const double from = ray.at_difference(2.0 * (printed - kHalfTenth) - rounded, d, next);
    const double to = ray.at_difference(2.0 * (printed + kHalfTenth) - rounded, d, next);
    const auto printed_at = [&](double at) {
      return 0.5 * (at - ray.focus_distance(at) + rounded);
    };

    if (to >= from && printed_at(from) <= printed + kHalfTenth + 1e-9 &&
        printed_at(to) >= printed - kHalfTenth - 1e-9) {
      if (found.high < 0.0) found.low = from;
      found.high = to;
    }
    d = next;
  }
  return found.high < 0.0 ? range(printed) : found;
}

}  // namespace cls::player
