// Values within an interval whose ends come from a server.
#pragma once

#include <algorithm>

namespace cls::soccer {

/// The value nearest to `value` between two ends in either order. std::clamp() is undefined for a
/// lower end above the upper one, which parameters of a server may give.
inline double between(double value, double end, double other_end) {
  return end <= other_end ? std::clamp(value, end, other_end) : std::clamp(value, other_end, end);
}

}  // namespace cls::soccer
