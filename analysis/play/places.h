// Parts of the pitch that several statistics speak of, as a team sees them: it attacks +x.
#pragma once

#include <cmath>

#include "soccer/geometry.h"
#include "soccer/pitch.h"

namespace cls::analysis {

/// The thirds meet at -17.5 and +17.5 m.
constexpr double kThirdBorder = soccer::kPitchLength / 6;

/// Within the opponent's penalty area.
inline bool in_opponents_box(soccer::Vec2 seen) {
  return seen.x > soccer::kHalfLength - soccer::kPenaltyAreaLength &&
         std::fabs(seen.y) < soccer::kPenaltyAreaWidth / 2;
}

}  // namespace cls::analysis
