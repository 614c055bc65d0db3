// An angle in degrees, normalized to [-180, 180].
#pragma once

#include <cmath>

#include "soccer/geometry.h"

namespace cls::soccer {

/// A direction on the pitch, or a difference of directions. 0 is +x; positive angles turn clockwise
/// (y points down). Used by the proxy; the simulator uses radians like rcssserver.
class AngleDeg {
 public:
  constexpr AngleDeg() = default;
  explicit AngleDeg(double degrees) : degrees_(math::normalize_degrees(degrees)) {}

  static AngleDeg of(Vec2 v) { return AngleDeg(direction_degrees(v)); }

  double degrees() const { return degrees_; }
  double radians() const { return math::to_radians(degrees_); }
  double abs() const { return std::fabs(degrees_); }

  friend AngleDeg operator+(AngleDeg a, AngleDeg b) { return AngleDeg(a.degrees_ + b.degrees_); }
  friend AngleDeg operator-(AngleDeg a, AngleDeg b) { return AngleDeg(a.degrees_ - b.degrees_); }
  friend AngleDeg operator+(AngleDeg a, double degrees) { return AngleDeg(a.degrees_ + degrees); }
  friend AngleDeg operator-(AngleDeg a, double degrees) { return AngleDeg(a.degrees_ - degrees); }
  friend AngleDeg operator-(AngleDeg a) { return AngleDeg(-a.degrees_); }
  friend bool operator==(AngleDeg a, AngleDeg b) { return a.degrees_ == b.degrees_; }

 private:
  double degrees_ = 0.0;
};

inline Vec2 polar(double length, AngleDeg angle) { return polar_degrees(length, angle.degrees()); }

}  // namespace cls::soccer
