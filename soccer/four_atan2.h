// SLEEF's atan2 of four doubles, for processors with AVX.
#pragma once

namespace cls::soccer::detail {

/// Reads four doubles from `y` and from `x`, writes four radians. Only where the processor has AVX.
void four_atan2(const double* y, const double* x, double* radians);

}  // namespace cls::soccer::detail
