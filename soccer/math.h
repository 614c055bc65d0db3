// Transcendental functions with the same bits on every x86-64 machine, and angle arithmetic.
#pragma once

namespace cls::soccer::math {

constexpr double kPi = 3.14159265358979323846;
constexpr double kEps = 1e-10;

/// These go through SLEEF's FMA-free scalar code, which rounds the same on every CPU; the C
/// library picks other code (and other last bits) where the CPU has FMA. Simulator, world model
/// and mock use no other. Error at most 1 ulp. Arguments and results in radians.
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
/// Both at once, cheaper than one after the other.
SinCos sincos(double x);

constexpr double to_radians(double degrees) { return degrees * kPi / 180.0; }
constexpr double to_degrees(double radians) { return radians * 180.0 / kPi; }

/// An angle in radians brought into [-pi, pi]; both ends are possible, as in the real server.
double normalize_radians(double angle);

/// An angle in degrees brought into [-180, 180].
double normalize_degrees(double angle);

/// Rounds to a multiple of `step`, half to even; a step below 1e-10 leaves the value alone.
double quantize(double value, double step);

}  // namespace cls::soccer::math
