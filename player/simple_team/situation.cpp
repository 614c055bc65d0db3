// Derived values of a situation.
#include "player/simple_team/situation.h"

#include <algorithm>

namespace cls::player {
namespace {

constexpr double kFar = 1000.0;  // no opponent known

}  // namespace

double Situation::nearest_opponent_to(Vec2 point) const {
  double nearest = kFar;
  for (const Vec2 opponent : opponents) nearest = std::min(nearest, distance(point, opponent));
  return nearest;
}

double Situation::lane_margin(Vec2 from, Vec2 to, double base, double spread) const {
  const Vec2 way = to - from;
  const double length = std::max(way.length(), 0.1);
  double margin = kFar;

  for (const Vec2 opponent : opponents) {
    const Vec2 relative = opponent - from;
    const double along = dot(relative, way) / length;
    if (along < 0.0) continue;

    const double passed = std::min(along, length);
    const double beside = distance(opponent, from + way * (passed / length));
    margin = std::min(margin, beside - base - spread * passed);
  }

  return margin;
}

bool Situation::is_nearest_to_ball() const {
  const double own = distance(position, ball);
  return std::ranges::none_of(teammates, [&](const SeenPlayer& teammate) {
    const double theirs = distance(teammate.position, ball);
    return !teammate.goalie && teammate.age <= kMaxAge &&
           (theirs < own || (theirs == own && teammate.unum < unum));
  });
}

}  // namespace cls::player
