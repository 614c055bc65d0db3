// Reproducible transcendental functions on SLEEF.
#include "soccer/math.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif
#include <sleef.h>

#include <cmath>

namespace cls::soccer::math {

#ifdef __SSE2__
namespace {

// SLEEF's vectors of two doubles: same bits as its scalar code, which has more branches.
__m128d one(double x) { return _mm_set_sd(x); }
double first(__m128d v) { return _mm_cvtsd_f64(v); }

}  // namespace

double sin(double x) { return first(Sleef_cinz_sind2_u10sse2(one(x))); }
double cos(double x) { return first(Sleef_cinz_cosd2_u10sse2(one(x))); }
double tan(double x) { return first(Sleef_cinz_tand2_u10sse2(one(x))); }
double atan(double x) { return first(Sleef_cinz_atand2_u10sse2(one(x))); }
double atan2(double y, double x) { return first(Sleef_cinz_atan2d2_u10sse2(one(y), one(x))); }
double exp(double x) { return first(Sleef_cinz_expd2_u10sse2(one(x))); }
double pow(double x, double y) { return first(Sleef_cinz_powd2_u10sse2(one(x), one(y))); }

SinCos sincos(double x) {
  const Sleef___m128d_2 both = Sleef_cinz_sincosd2_u10sse2(one(x));
  return {first(both.x), first(both.y)};
}
#else
double sin(double x) { return Sleef_cinz_sind1_u10purec(x); }
double cos(double x) { return Sleef_cinz_cosd1_u10purec(x); }
double tan(double x) { return Sleef_cinz_tand1_u10purec(x); }
double atan(double x) { return Sleef_cinz_atand1_u10purec(x); }
double atan2(double y, double x) { return Sleef_cinz_atan2d1_u10purec(y, x); }
double exp(double x) { return Sleef_cinz_expd1_u10purec(x); }
double pow(double x, double y) { return Sleef_cinz_powd1_u10purec(x, y); }

SinCos sincos(double x) {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(x);
  return {both.x, both.y};
}
#endif

double asin(double x) { return Sleef_cinz_asind1_u10purec(x); }
double acos(double x) { return Sleef_cinz_acosd1_u10purec(x); }
double log(double x) { return Sleef_cinz_logd1_u10purec(x); }

double normalize_radians(double angle) {
  if (std::fabs(angle) > 2.0 * kPi) angle = std::fmod(angle, 2.0 * kPi);
  if (angle < -kPi) angle += 2.0 * kPi;
  if (angle > kPi) angle -= 2.0 * kPi;
  return angle;
}

double normalize_degrees(double angle) {
  if (std::fabs(angle) > 360.0) angle = std::fmod(angle, 360.0);
  if (angle < -180.0) angle += 360.0;
  if (angle > 180.0) angle -= 360.0;
  return angle;
}

double quantize(double value, double step) {
  if (step < kEps) return value;
  return std::rint(value / step) * step;
}

}  // namespace cls::soccer::math
