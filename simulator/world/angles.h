// Degrees and radians rounded to the last bit as the real server does.
#pragma once

#include "soccer/math.h"

namespace cls::simulator {

/// For angles that are told as truncated degrees: a neck turned by 20 degrees is shown as 20 or 19,
/// and which of them depends on the last bit of both conversions.
constexpr double exact_radians(double degrees) { return degrees * (soccer::math::kPi / 180.0); }
constexpr double exact_degrees(double radians) { return radians * (180.0 / soccer::math::kPi); }

/// Towards zero, as sense_body and hear tell them.
constexpr int truncated_degrees(double radians) { return static_cast<int>(exact_degrees(radians)); }

}  // namespace cls::simulator
