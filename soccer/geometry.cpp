// Plane geometry with the edge cases of rcssserver.
#include "soccer/geometry.h"

#include <algorithm>

namespace cls::soccer {

double direction_radians(Vec2 v) { return v.is_zero() ? 0.0 : math::atan2(v.y, v.x); }
double direction_degrees(Vec2 v) { return math::to_degrees(direction_radians(v)); }

Vec2 polar_radians(double length, double angle) {
  const auto [sin, cos] = math::sincos(angle);
  return {length * cos, length * sin};
}

Vec2 polar_degrees(double length, double angle) {
  return polar_radians(length, math::to_radians(angle));
}

Vec2 rotated_radians(Vec2 v, double angle) {
  const auto [sin, cos] = math::sincos(angle);
  return {v.x * cos - v.y * sin, v.x * sin + v.y * cos};
}

Vec2 rotated_degrees(Vec2 v, double angle) { return rotated_radians(v, math::to_radians(angle)); }

Vec2 with_length(Vec2 v, double length) { return v * (length / std::max(v.length(), math::kEps)); }

Vec2 nearest_horizontal_edge(const Rect& rect, Vec2 p) {
  const bool top_is_nearer = std::fabs(p.y - rect.top) < std::fabs(p.y - rect.bottom);
  return {std::clamp(p.x, rect.left, rect.right), top_is_nearer ? rect.top : rect.bottom};
}

Vec2 nearest_vertical_edge(const Rect& rect, Vec2 p) {
  const bool left_is_nearer = std::fabs(p.x - rect.left) < std::fabs(p.x - rect.right);
  return {left_is_nearer ? rect.left : rect.right, std::clamp(p.y, rect.top, rect.bottom)};
}

Vec2 nearest_edge(const Rect& rect, Vec2 p) {
  const double to_vertical = std::min(std::fabs(p.x - rect.left), std::fabs(p.x - rect.right));
  const double to_horizontal = std::min(std::fabs(p.y - rect.top), std::fabs(p.y - rect.bottom));
  return to_vertical < to_horizontal ? nearest_vertical_edge(rect, p)
                                     : nearest_horizontal_edge(rect, p);
}

Vec2 nearest_edge(const Circle& circle, Vec2 p) {
  Vec2 away = p - circle.center;
  if (away.is_zero()) away = {math::kEps, math::kEps};
  return circle.center + with_length(away, circle.radius);
}

Vec2 nearest_point(const Segment& segment, Vec2 p) {
  const Vec2 along = segment.to - segment.from;
  const double length2 = along.squared_length();
  if (length2 == 0.0) return segment.from;
  const double t = std::clamp(dot(p - segment.from, along) / length2, 0.0, 1.0);
  return segment.from + along * t;
}

double distance(const Segment& segment, Vec2 p) { return distance(nearest_point(segment, p), p); }

}  // namespace cls::soccer
