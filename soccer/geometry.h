// Points, vectors, rectangles and circles on the pitch in meters; function names state the angle
// unit.
#pragma once

#include <cmath>

#include "soccer/math.h"

namespace cls::soccer {

/// A point or a vector. x points right, y down, so positive angles turn clockwise.
struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(Vec2 a, double k) { return {a.x * k, a.y * k}; }
  friend constexpr Vec2 operator*(double k, Vec2 a) { return a * k; }
  friend constexpr Vec2 operator/(Vec2 a, double k) { return {a.x / k, a.y / k}; }
  friend constexpr bool operator==(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }
  constexpr Vec2& operator+=(Vec2 b) { return *this = *this + b; }
  constexpr Vec2& operator-=(Vec2 b) { return *this = *this - b; }
  constexpr Vec2& operator*=(double k) { return *this = *this * k; }

  constexpr double squared_length() const { return x * x + y * y; }
  double length() const { return std::sqrt(squared_length()); }
  constexpr bool is_zero() const { return x == 0.0 && y == 0.0; }
};

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double distance(Vec2 a, Vec2 b) { return (a - b).length(); }
constexpr double squared_distance(Vec2 a, Vec2 b) { return (a - b).squared_length(); }

/// Direction of a vector in radians; 0 for the zero vector.
double direction_radians(Vec2 v);
/// Direction of a vector in degrees; 0 for the zero vector.
double direction_degrees(Vec2 v);

Vec2 polar_radians(double length, double angle);
Vec2 polar_degrees(double length, double angle);

/// `v` rotated by `angle` radians, clockwise for positive angles.
Vec2 rotated_radians(Vec2 v, double angle);
Vec2 rotated_degrees(Vec2 v, double angle);

/// `v` scaled to `length`. Vectors shorter than 1e-10 are divided by 1e-10 instead of their length;
/// a negative length reverses the direction (both as in rcssserver).
Vec2 with_length(Vec2 v, double length);

/// An axis-parallel rectangle, including its border.
struct Rect {
  double left = 0.0;
  double right = 0.0;
  double top = 0.0;  ///< smaller y
  double bottom = 0.0;

  static constexpr Rect centered(Vec2 center, double width, double height) {
    return {center.x - width / 2, center.x + width / 2, center.y - height / 2,
            center.y + height / 2};
  }
  constexpr bool contains(Vec2 p) const {
    return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom;
  }
};

/// Nearest point on the top or bottom line (top only if strictly nearer), x clamped.
Vec2 nearest_horizontal_edge(const Rect& rect, Vec2 p);
/// Nearest point on the left or right line (left only if strictly nearer), y clamped.
Vec2 nearest_vertical_edge(const Rect& rect, Vec2 p);
/// The nearer of both; the horizontal one for equal distances.
Vec2 nearest_edge(const Rect& rect, Vec2 p);

/// A circle, including its border.
struct Circle {
  Vec2 center;
  double radius = 0.0;

  constexpr bool contains(Vec2 p) const { return squared_distance(p, center) <= radius * radius; }
};

/// Point of the circle in the direction of `p`; diagonal when `p` is the center.
Vec2 nearest_edge(const Circle& circle, Vec2 p);

/// A line segment.
struct Segment {
  Vec2 from;
  Vec2 to;
};

/// Nearest point of the segment to `p`, and its distance.
Vec2 nearest_point(const Segment& segment, Vec2 p);
double distance(const Segment& segment, Vec2 p);

}  // namespace cls::soccer
