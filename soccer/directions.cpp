// SLEEF's atan2 of two or four doubles; see math.cpp. Its results have the same bits at any width.
#include "soccer/directions.h"

#include <algorithm>

#if defined(__x86_64__)
#include <emmintrin.h>
#include <sleef.h>

#include "soccer/four_atan2.h"
#define CLS_X86 1
#endif

namespace cls::soccer {
namespace {

double degrees_of(Vec2 vector, double radians) {
  return vector.is_zero() ? 0.0 : math::to_degrees(radians);
}

#ifdef CLS_X86
constexpr std::size_t kWidth = 4;

void four_directions(const Vec2* vectors, double* degrees) {
  std::array<double, kWidth> y;
  std::array<double, kWidth> x;
  for (std::size_t i = 0; i < kWidth; ++i) {
    y[i] = vectors[i].y;
    x[i] = vectors[i].x;
  }
  std::array<double, kWidth> radians;
  detail::four_atan2(y.data(), x.data(), radians.data());
  for (std::size_t i = 0; i < kWidth; ++i) degrees[i] = degrees_of(vectors[i], radians[i]);
}
#endif

}  // namespace

std::array<double, 2> direction_pair(Vec2 a, Vec2 b) {
#ifdef CLS_X86
  const __m128d y = _mm_setr_pd(a.y, b.y);
  const __m128d x = _mm_setr_pd(a.x, b.x);
  std::array<double, 2> radians;
  _mm_storeu_pd(radians.data(), Sleef_cinz_atan2d2_u10sse2(y, x));
  return {degrees_of(a, radians[0]), degrees_of(b, radians[1])};
#else
  return {direction_degrees(a), direction_degrees(b)};
#endif
}

void directions(const Vec2* vectors, std::size_t count, double* degrees) {
  std::size_t done = 0;
#ifdef CLS_X86
  static const bool wide = __builtin_cpu_supports("avx") != 0;
  for (; wide && done + kWidth <= count; done += kWidth) {
    four_directions(vectors + done, degrees + done);
  }
#endif
  for (; done < count; done += 2) {
    const std::size_t other = std::min(done + 1, count - 1);
    const auto [first, second] = direction_pair(vectors[done], vectors[other]);
    degrees[done] = first;
    degrees[other] = second;
  }
}

}  // namespace cls::soccer
