// Areas of the pitch as a team sees it: it attacks +x.
#pragma once

#include <cmath>

#include "soccer/geometry.h"
#include "soccer/pitch.h"

namespace cls::analysis {

/// Borders of the thirds: -17.5 and +17.5 m.
constexpr double kThirdBorder = soccer::kPitchLength / 6;

/// The third of the pitch where x is.
inline const char* third_name(double x) {
  if (x < -kThirdBorder) return "own third";
  return x < kThirdBorder ? "middle" : "their third";
}

/// True inside the opponent's penalty area.
inline bool in_opponent_box(soccer::Vec2 seen) {
  return seen.x > soccer::kHalfLength - soccer::kPenaltyAreaLength &&
         std::fabs(seen.y) < soccer::kPenaltyAreaWidth / 2;
}

}  // namespace cls::analysis
