// SLEEF's atan2 of two doubles; see math.cpp.
#include "soccer/direction_pair.h"

#ifdef __SSE2__
#include <emmintrin.h>
#include <sleef.h>
#endif

namespace cls::soccer {

std::array<double, 2> direction_pair(Vec2 a, Vec2 b) {
#ifdef __SSE2__
  const __m128d y = _mm_setr_pd(a.y, b.y);
  const __m128d x = _mm_setr_pd(a.x, b.x);
  std::array<double, 2> radians;
  _mm_storeu_pd(radians.data(), Sleef_cinz_atan2d2_u10sse2(y, x));
  return {a.is_zero() ? 0.0 : math::to_degrees(radians[0]),
          b.is_zero() ? 0.0 : math::to_degrees(radians[1])};
#else
  return {direction_degrees(a), direction_degrees(b)};
#endif
}

}  // namespace cls::soccer
