// Areas in front of the goals.
#include "simulator/referee/areas.h"

#include <algorithm>
#include <cmath>

#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

using soccer::Rect;
using soccer::math::kEps;

constexpr double kPenaltyFront = soccer::kHalfLength - soccer::kPenaltyAreaLength;
constexpr double kPenaltyHalfWidth = soccer::kPenaltyAreaWidth / 2.0;
constexpr double kGoalFront = soccer::kHalfLength - soccer::kGoalAreaLength;
constexpr double kGoalHalfWidth = soccer::kGoalAreaWidth / 2.0;
// The rules' own figure, whatever the parameter ball_size says.
constexpr double kBallDiameter = 0.17;

// True if the area at this end (-1 left, +1 right) counts for `side`.
bool is_meant(Side side, int end) { return sign(side) != end; }

}  // namespace

Vec2 truncated(Vec2 point) {
  return {std::clamp(point.x, -soccer::kHalfLength, soccer::kHalfLength),
          std::clamp(point.y, -soccer::kHalfWidth, soccer::kHalfWidth)};
}

Vec2 out_of_penalty_area(Side side, Vec2 point) {
  if (std::fabs(point.y) > kPenaltyHalfWidth) return point;
  for (const int end : {-1, 1}) {
    if (is_meant(side, end) && point.x * end >= kPenaltyFront) {
      return {(kPenaltyFront - kEps) * end, (kPenaltyHalfWidth + kEps) * (point.y > 0.0 ? 1 : -1)};
    }
  }
  return point;
}

Vec2 out_of_goal_area(Side side, Vec2 point) {
  if (std::fabs(point.y) > kGoalHalfWidth) return point;
  for (const int end : {-1, 1}) {
    if (is_meant(side, end) && point.x * end >= kGoalFront) {
      return {(kGoalFront - kEps) * end, point.y};
    }
  }
  return point;
}

bool in_penalty_area(Side side, Vec2 point) {
  const double centre = soccer::kHalfLength - soccer::kPenaltyAreaLength / 2.0;
  for (const int end : {-1, 1}) {
    const Rect area = Rect::centred({centre * end, 0.0}, soccer::kPenaltyAreaLength + kBallDiameter,
                                    soccer::kPenaltyAreaWidth + kBallDiameter);
    if (is_meant(side, end) && area.contains(point)) return true;
  }
  return false;
}

bool in_goal_area(Side side, Vec2 point) {
  return point.x * -sign(side) >= kGoalFront && point.x * -sign(side) <= soccer::kHalfLength &&
         std::fabs(point.y) <= kGoalHalfWidth;
}

}  // namespace cls::simulator
