// SLEEF's functions of two or four doubles, where math.cpp has SLEEF. Their results have the same
// bits at any width.
#include "soccer/directions.h"

#include <algorithm>

#include "soccer/math_library.h"
#ifdef CLS_SLEEF
#include <emmintrin.h>
#include <sleef.h>

#include "soccer/four_wide.h"
#endif

namespace cls::soccer {
namespace {

double degrees_of(Vec2 vector, double radians) {
  return vector.is_zero() ? 0.0 : math::to_degrees(radians);
}
double radians_of(Vec2 vector, double radians) { return vector.is_zero() ? 0.0 : radians; }

std::array<double, 2> atan2_pair(Vec2 a, Vec2 b) {
#ifdef CLS_SLEEF
  const __m128d y = _mm_setr_pd(a.y, b.y);
  const __m128d x = _mm_setr_pd(a.x, b.x);
  std::array<double, 2> radians;
  _mm_storeu_pd(radians.data(), Sleef_cinz_atan2d2_u10sse2(y, x));
  return radians;
#else
  return {math::atan2(a.y, a.x), math::atan2(b.y, b.x)};
#endif
}

#ifdef CLS_SLEEF
constexpr std::size_t kWidth = 4;

bool has_wide() {
  static const bool wide = __builtin_cpu_supports("avx") != 0;
  return wide;
}

std::array<double, kWidth> atan2_of_four(const Vec2* vectors) {
  std::array<double, kWidth> y;
  std::array<double, kWidth> x;
  for (std::size_t i = 0; i < kWidth; ++i) {
    y[i] = vectors[i].y;
    x[i] = vectors[i].x;
  }
  std::array<double, kWidth> radians;
  detail::four_atan2(y.data(), x.data(), radians.data());
  return radians;
}
#endif

/// Writes convert(vector, its atan2) for each vector.
template <typename Convert>
void convert_all(const Vec2* vectors, std::size_t count, double* out, Convert convert) {
  std::size_t done = 0;
#ifdef CLS_SLEEF
  for (; has_wide() && done + kWidth <= count; done += kWidth) {
    const auto radians = atan2_of_four(vectors + done);
    for (std::size_t i = 0; i < kWidth; ++i) out[done + i] = convert(vectors[done + i], radians[i]);
  }
#endif
  for (; done < count; done += 2) {
    const std::size_t other = std::min(done + 1, count - 1);
    const auto [first, second] = atan2_pair(vectors[done], vectors[other]);
    out[done] = convert(vectors[done], first);
    out[other] = convert(vectors[other], second);
  }
}

}  // namespace

std::array<double, 2> direction_pair(Vec2 a, Vec2 b) {
  const auto [first, second] = atan2_pair(a, b);
  return {degrees_of(a, first), degrees_of(b, second)};
}

void directions(const Vec2* vectors, std::size_t count, double* degrees) {
  convert_all(vectors, count, degrees, degrees_of);
}

void directions_radians(const Vec2* vectors, std::size_t count, double* radians) {
  convert_all(vectors, count, radians, radians_of);
}

void unit_vectors(const double* radians, std::size_t count, Vec2* vectors) {
  std::size_t done = 0;
#ifdef CLS_SLEEF
  for (; has_wide() && done + kWidth <= count; done += kWidth) {
    std::array<double, kWidth> sin;
    std::array<double, kWidth> cos;
    detail::four_sincos(radians + done, sin.data(), cos.data());
    for (std::size_t i = 0; i < kWidth; ++i) vectors[done + i] = {cos[i], sin[i]};
  }
#endif
  for (; done < count; ++done) vectors[done] = polar_radians(1.0, radians[done]);
}

}  // namespace cls::soccer
