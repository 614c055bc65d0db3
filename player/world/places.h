// Places of the pitch as the own team sees it, which attacks +x.
#pragma once

#include <algorithm>
#include <cmath>

#include "player/world/vocabulary.h"
#include "soccer/pitch.h"

namespace cls::player {

constexpr Vec2 kOwnGoal{-soccer::kHalfLength, 0.0};
constexpr Vec2 kOpponentGoal{soccer::kHalfLength, 0.0};

/// True at least `inset` meters inside the lines; false on a line, and for a place that is not a
/// number.
inline bool inside_pitch(Vec2 point, double inset = 0.0) {
  return std::fabs(point.x) < soccer::kHalfLength - inset &&
         std::fabs(point.y) < soccer::kHalfWidth - inset;
}

/// True beyond lines that are moved inside by `inset` meters; false on a line, and for a place that
/// is not a number.
inline bool outside_pitch(Vec2 point, double inset = 0.0) {
  return std::fabs(point.x) > soccer::kHalfLength - inset ||
         std::fabs(point.y) > soccer::kHalfWidth - inset;
}

/// True at least `inset` meters inside our penalty area, and behind our goal line.
inline bool in_own_box(Vec2 point, double inset = 0.0) {
  return point.x < -soccer::kHalfLength + soccer::kPenaltyAreaLength - inset &&
         std::fabs(point.y) < soccer::kPenaltyAreaWidth / 2.0 - inset;
}

/// The point moved inside lines that are `inset` meters inside the pitch.
inline Vec2 clamped_to_pitch(Vec2 point, double inset = 0.0) {
  return {std::clamp(point.x, -soccer::kHalfLength + inset, soccer::kHalfLength - inset),
          std::clamp(point.y, -soccer::kHalfWidth + inset, soccer::kHalfWidth - inset)};
}

}  // namespace cls::player
