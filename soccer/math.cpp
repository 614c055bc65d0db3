// Reproducible transcendental functions: those of SLEEF, or their portable twins.
#include "soccer/math.h"

#include "soccer/math_library.h"
#ifdef CLS_SLEEF
#include <emmintrin.h>
#include <sleef.h>
#else
#include "soccer/portable_math.h"
#endif

#include <cmath>

namespace cls::soccer::math {

#ifdef CLS_SLEEF
namespace {

// Vectors of two doubles: same bits as SLEEF's scalar code, which has more branches.
__m128d one(double x) { return _mm_set_sd(x); }
double first(__m128d v) { return _mm_cvtsd_f64(v); }

}  // namespace

double sin(double x) { return first(Sleef_cinz_sind2_u10sse2(one(x))); }
double cos(double x) { return first(Sleef_cinz_cosd2_u10sse2(one(x))); }
double tan(double x) { return first(Sleef_cinz_tand2_u10sse2(one(x))); }
double asin(double x) { return Sleef_cinz_asind1_u10purec(x); }
double acos(double x) { return Sleef_cinz_acosd1_u10purec(x); }
double atan(double x) { return first(Sleef_cinz_atand2_u10sse2(one(x))); }
double atan2(double y, double x) { return first(Sleef_cinz_atan2d2_u10sse2(one(y), one(x))); }
double exp(double x) { return first(Sleef_cinz_expd2_u10sse2(one(x))); }
double log(double x) { return Sleef_cinz_logd1_u10purec(x); }
double pow(double x, double y) { return first(Sleef_cinz_powd2_u10sse2(one(x), one(y))); }

SinCos sincos(double x) {
  const Sleef___m128d_2 both = Sleef_cinz_sincosd2_u10sse2(one(x));
  return {first(both.x), first(both.y)};
}
#else
double sin(double x) { return portable::sin(x); }
double cos(double x) { return portable::cos(x); }
double tan(double x) { return portable::tan(x); }
double asin(double x) { return portable::asin(x); }
double acos(double x) { return portable::acos(x); }
double atan(double x) { return portable::atan(x); }
double atan2(double y, double x) { return portable::atan2(y, x); }
double exp(double x) { return portable::exp(x); }
double log(double x) { return portable::log(x); }
double pow(double x, double y) { return portable::pow(x, y); }
SinCos sincos(double x) { return portable::sincos(x); }
#endif

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
