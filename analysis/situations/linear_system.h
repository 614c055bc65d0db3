// Sums of products, and small systems of linear equations.
#pragma once

#include <array>
#include <cstddef>

namespace cls::analysis {

template <std::size_t kSize>
using Row = std::array<double, kSize>;
template <std::size_t kSize>
using Matrix = std::array<Row<kSize>, kSize>;

template <std::size_t kSize>
double dot(const Row<kSize>& a, const Row<kSize>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kSize; ++i) sum += a[i] * b[i];
  return sum;
}

/// The solution x of a x = b, by elimination. `a` is symmetric and positive definite.
template <std::size_t kSize>
Row<kSize> solve(Matrix<kSize> a, Row<kSize> b) {
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t row = i + 1; row < kSize; ++row) {
      const double factor = a[row][i] / a[i][i];
      for (std::size_t column = i; column < kSize; ++column) {
        a[row][column] -= factor * a[i][column];
      }
      b[row] -= factor * b[i];
    }
  }

  Row<kSize> x{};
  for (std::size_t i = kSize; i-- > 0;) {
    double rest = b[i];
    for (std::size_t column = i + 1; column < kSize; ++column) rest -= a[i][column] * x[column];
    x[i] = rest / a[i][i];
  }
  return x;
}

}  // namespace cls::analysis
