// SLEEF's functions of four doubles, for processors with AVX.
#pragma once

namespace cls::soccer::detail {

// They read and write four doubles through each pointer. Only where the processor has AVX.

void four_atan2(const double* y, const double* x, double* radians);
void four_sincos(const double* radians, double* sin, double* cos);

}  // namespace cls::soccer::detail
