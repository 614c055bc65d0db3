// Transcendental functions with identical results on all CPUs, and angle arithmetic.
#pragma once

namespace cls::soccer::math {

constexpr double kPi = 3.14159265358979323846;
constexpr double kEps = 1e-10;

/// SLEEF's functions without FMA, which round equally on all CPUs; the C library uses other code,
/// with other last bits, on CPUs with FMA. Where SLEEF is missing, their twins of portable_math.h.
/// Simulator, world model and mock use only these functions. Error at most 1 ulp. Angles in
/// radians.
double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double pow(double x, double y);

struct SinCos {
  double sin;
  double cos;
};
/// Cheaper than sin() and cos().
SinCos sincos(double x);

constexpr double to_radians(double degrees) { return degrees * kPi / 180.0; }
constexpr double to_degrees(double radians) { return radians * 180.0 / kPi; }

/// Normalizes an angle to [-pi, pi]; both ends are possible, as in rcssserver.
double normalize_radians(double angle);

/// Normalizes an angle to [-180, 180].
double normalize_degrees(double angle);

/// Rounds to a multiple of `step`, half to even; a step below 1e-10 leaves the value unchanged.
double quantize(double value, double step);

}  // namespace cls::soccer::math
