// Two numbers that the processor computes together, at the price of one.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#else
#include <algorithm>
#endif

#include "soccer/geometry.h"

namespace cls::training {

#ifdef __SSE2__

class Pair {
 public:
  Pair(double first, double second) : both_(_mm_set_pd(second, first)) {}
  explicit Pair(const soccer::Vec2& v) : both_(_mm_loadu_pd(&v.x)) {}
  static Pair of(double both) { return _mm_set1_pd(both); }

  double first() const { return _mm_cvtsd_f64(both_); }
  double second() const { return swapped().first(); }
  Pair swapped() const { return _mm_shuffle_pd(both_, both_, 1); }
  /// std::clamp() without its branches, which processors predict badly here.
  Pair clamped(double low, double high) const {
    return _mm_min_pd(of(high).both_, _mm_max_pd(of(low).both_, both_));
  }
  void store(float* out) const {
    _mm_storel_pi(reinterpret_cast<__m64*>(out), _mm_cvtpd_ps(both_));
  }

  friend Pair operator+(Pair a, Pair b) { return _mm_add_pd(a.both_, b.both_); }
  friend Pair operator-(Pair a, Pair b) { return _mm_sub_pd(a.both_, b.both_); }
  friend Pair operator*(Pair a, Pair b) { return _mm_mul_pd(a.both_, b.both_); }
  friend Pair operator/(Pair a, Pair b) { return _mm_div_pd(a.both_, b.both_); }

 private:
  Pair(__m128d both) : both_(both) {}

  __m128d both_;
};

#else

class Pair {
 public:
  Pair(double first, double second) : first_(first), second_(second) {}
  explicit Pair(const soccer::Vec2& v) : Pair(v.x, v.y) {}
  static Pair of(double both) { return {both, both}; }

  double first() const { return first_; }
  double second() const { return second_; }
  Pair swapped() const { return {second_, first_}; }
  Pair clamped(double low, double high) const {
    return {std::clamp(first_, low, high), std::clamp(second_, low, high)};
  }
  void store(float* out) const {
    out[0] = static_cast<float>(first_);
    out[1] = static_cast<float>(second_);
  }

  friend Pair operator+(Pair a, Pair b) { return {a.first_ + b.first_, a.second_ + b.second_}; }
  friend Pair operator-(Pair a, Pair b) { return {a.first_ - b.first_, a.second_ - b.second_}; }
  friend Pair operator*(Pair a, Pair b) { return {a.first_ * b.first_, a.second_ * b.second_}; }
  friend Pair operator/(Pair a, Pair b) { return {a.first_ / b.first_, a.second_ / b.second_}; }

 private:
  double first_;
  double second_;
};

#endif

}  // namespace cls::training
