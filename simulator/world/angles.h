// Conversions between degrees and radians with the same last bit as in rcssserver.
#pragma once

#include <cmath>

#include "soccer/math.h"

namespace cls::simulator {

/// Converts angles that messages truncate to whole degrees: the last bits of both conversions
/// decide whether a neck turned by 20 degrees is sent as 20 or 19.
constexpr double exact_radians(double degrees) { return degrees * (soccer::math::kPi / 180.0); }
constexpr double exact_degrees(double radians) { return radians * (180.0 / soccer::math::kPi); }

/// Whole degrees, rounded toward zero as in sense_body and hear messages.
constexpr int truncated_degrees(double radians) { return static_cast<int>(exact_degrees(radians)); }

/// Whole degrees, rounded to the nearest.
inline int rounded_degrees(double radians) {
  return static_cast<int>(std::rint(exact_degrees(radians)));
}

}  // namespace cls::simulator
