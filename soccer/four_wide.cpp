// The whole file is compiled for AVX: Clang passes vectors of four doubles to functions as the
// file's flags say, whatever target a function has. It includes no header with functions that the
// linker might share with other files.
#include "soccer/four_wide.h"

#ifdef __AVX__
#include <immintrin.h>
#include <sleef.h>

namespace cls::soccer::detail {

void four_atan2(const double* y, const double* x, double* radians) {
  _mm256_storeu_pd(radians, Sleef_cinz_atan2d4_u10avx(_mm256_loadu_pd(y), _mm256_loadu_pd(x)));
}

void four_sincos(const double* radians, double* sin, double* cos) {
  const Sleef___m256d_2 both = Sleef_cinz_sincosd4_u10avx(_mm256_loadu_pd(radians));
  _mm256_storeu_pd(sin, both.x);
  _mm256_storeu_pd(cos, both.y);
}

}  // namespace cls::soccer::detail
#endif
