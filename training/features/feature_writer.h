// Appends features to an array, clipped to the bounds that the specification promises.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>

#include "soccer/geometry.h"
#include "soccer/math.h"
#include "training/features/pair.h"

namespace cls::training {

/// std::clamp() without its branches, which processors predict badly here.
inline double clamped(double value, double low, double high) {
#ifdef __SSE2__
  const __m128d raised = _mm_max_sd(_mm_set_sd(low), _mm_set_sd(value));
  return _mm_cvtsd_f64(_mm_min_sd(_mm_set_sd(high), raised));
#else
  return std::clamp(value, low, high);
#endif
}

class FeatureWriter {
 public:
  explicit FeatureWriter(float* out) : out_(out) {}

  void value(double value, double low = -1.0, double high = 1.0) {
    *out_++ = static_cast<float>(clamped(value, low, high));
  }
  void values(Pair both, double low = -1.0, double high = 1.0) {
    both.clamped(low, high).store(out_);
    out_ += 2;
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
  void direction(soccer::Vec2 v, soccer::Vec2 axis) { direction(v, v.length(), axis); }
  /// The same of a vector whose length is known.
  void direction(soccer::Vec2 v, double length, soccer::Vec2 axis) {
    value(length > 0.0 ? cross(axis, v) / length : 0.0);
    value(length > 0.0 ? dot(axis, v) / length : 1.0);
  }

 private:
  float* out_;
};

}  // namespace cls::training
