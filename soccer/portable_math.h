// The functions of math.h without SLEEF, for processors and compilers that it does not serve.
#pragma once

#include "soccer/math.h"

namespace cls::soccer::math::portable {

/// The same bits as those of math.h, for all arguments (a NaN is any NaN); only IEEE arithmetic and
/// square roots.
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
SinCos sincos(double x);

}  // namespace cls::soccer::math::portable
