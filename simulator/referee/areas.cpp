// Penalty areas, goal areas and the goal line.
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
// Constant of the rules; independent of the parameter ball_size.
constexpr double kBallDiameter = 0.17;

// True if the area at this end (-1 left, +1 right) is relevant for `side`.
bool applies_to(Side side, int end) { return sign(side) != end; }

}  // namespace

Vec2 clamp_to_pitch(Vec2 point) {
  return {std::clamp(point.x, -soccer::kHalfLength, soccer::kHalfLength),
          std::clamp(point.y, -soccer::kHalfWidth, soccer::kHalfWidth)};
}

Vec2 move_out_of_penalty_area(Side side, Vec2 point) {
  if (std::fabs(point.y) > kPenaltyHalfWidth) return point;
  for (const int end : {-1, 1}) {
    if (applies_to(side, end) && point.x * end >= kPenaltyFront) {
      return {(kPenaltyFront - kEps) * end, (kPenaltyHalfWidth + kEps) * (point.y > 0.0 ? 1 : -1)};
    }
  }
  return point;
}

Vec2 move_out_of_goal_area(Side side, Vec2 point) {
  if (std::fabs(point.y) > kGoalHalfWidth) return point;
  for (const int end : {-1, 1}) {
    if (applies_to(side, end) && point.x * end >= kGoalFront) {
      return {(kGoalFront - kEps) * end, point.y};
    }
  }
  return point;
}

bool in_penalty_area(Side side, Vec2 point) {
  const double center = soccer::kHalfLength - soccer::kPenaltyAreaLength / 2.0;
  for (const int end : {-1, 1}) {
    const Rect area =
        Rect::centered({center * end, 0.0}, soccer::kPenaltyAreaLength + kBallDiameter,
                       soccer::kPenaltyAreaWidth + kBallDiameter);
    if (applies_to(side, end) && area.contains(point)) return true;
  }
  return false;
}

bool in_goal_area(Side side, Vec2 point) {
  return point.x * -sign(side) >= kGoalFront && point.x * -sign(side) <= soccer::kHalfLength &&
         std::fabs(point.y) <= kGoalHalfWidth;
}

double goal_line(const World& world) { return soccer::kHalfLength + world.params().ball_size; }

bool crossed_goal_line(const World& world, Side defender, Vec2 before) {
  const Vec2 now = world.ball.position;
  const double line = goal_line(world);
  const double width = world.params().goal_width / 2.0 + soccer::kGoalPostRadius;
  if (before.x == now.x || std::fabs(now.x) <= line || std::fabs(before.x) > line ||
      sign(defender) * now.x >= 0.0 ||
      (std::fabs(before.y) > width && std::fabs(before.x) > soccer::kHalfLength)) {
    return false;
  }
  const double x = -sign(defender) * line;
  const double y = before.y + (now.y - before.y) * (x - before.x) / (now.x - before.x);
  return std::fabs(y) <= width;
}

}  // namespace cls::simulator
