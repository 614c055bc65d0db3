// Appends features to an array, clipped to the bounds that the specification promises.
#pragma once

#include <algorithm>

#include "soccer/geometry.h"
#include "soccer/math.h"

namespace cls::training {

class FeatureWriter {
 public:
  explicit FeatureWriter(float* out) : out_(out) {}

  void value(double value, double low = -1.0, double high = 1.0) {
    *out_++ = static_cast<float>(std::clamp(value, low, high));
  }
  /// 1 or -1.
  void flag(bool on) { *out_++ = on ? 1.0F : -1.0F; }
  /// `low`..`high` scaled to -1..1.
  void scaled(double number, double low, double high) {
    value((number - low) / (high - low) * 2.0 - 1.0);
  }
  void same(int count, float number) {
    for (int i = 0; i < count; ++i) *out_++ = number;
  }
  void angle(double radians) {
    const soccer::math::SinCos both = soccer::math::sincos(radians);
    value(both.sin);
    value(both.cos);
  }
  /// Sine and cosine of the angle from direction `axis` (a unit vector) to `v`; (0, 1) for the
  /// zero vector. Needs no transcendental function.
  void direction(soccer::Vec2 v, soccer::Vec2 axis) {
    const double length = v.length();
    value(length > 0.0 ? cross(axis, v) / length : 0.0);
    value(length > 0.0 ? dot(axis, v) / length : 1.0);
  }

 private:
  float* out_;
};

}  // namespace cls::training
