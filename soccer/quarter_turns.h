// Angles as whole quarter turns and a rest, for portable_math.cpp.
#pragma once

#include <cstdint>

#include "soccer/double_double.h"

namespace cls::soccer::math::portable {

struct QuarterTurns {
  DoubleDouble rest;       ///< radians, in about [-pi/4, pi/4]
  std::int32_t count = 0;  ///< modulo 4
};

/// For finite angles of any magnitude, from 10^14 radians on: multiplies by 1 / (2 pi) as far as
/// its digits reach into the fraction.
QuarterTurns quarter_turns_of_large(double radians);

}  // namespace cls::soccer::math::portable
