// Cyclic Jacobi rotations: simple and accurate for a few dozen dimensions.
#include "tournament/tuning/symmetric_matrix.h"

#include <algorithm>
#include <cmath>

namespace cls::tournament {
namespace {

double off_diagonal(const SymmetricMatrix& matrix) {
  double sum = 0.0;
  for (std::size_t row = 0; row < matrix.size(); ++row) {
    for (std::size_t column = 0; column < row; ++column) {
      sum += matrix(row, column) * matrix(row, column);
    }
  }
  return sum;
}

// Makes the element at (p, q) zero.
void rotate(SymmetricMatrix& matrix, ColumnVectors& vectors, std::size_t p, std::size_t q) {
  const double apart = matrix(q, q) - matrix(p, p);
  const double theta = apart / (2 * matrix(p, q));
  const double tangent = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double cosine = 1 / std::sqrt(tangent * tangent + 1);
  const double sine = tangent * cosine;

  const double change = tangent * matrix(p, q);
  matrix.set(p, p, matrix(p, p) - change);
  matrix.set(q, q, matrix(q, q) + change);
  matrix.set(p, q, 0.0);

  for (std::size_t k = 0; k < matrix.size(); ++k) {
    const double vp = vectors(k, p);
    const double vq = vectors(k, q);
    vectors(k, p) = cosine * vp - sine * vq;
    vectors(k, q) = sine * vp + cosine * vq;
    if (k == p || k == q) continue;
    const double mp = matrix(k, p);
    const double mq = matrix(k, q);
    matrix.set(k, p, cosine * mp - sine * mq);
    matrix.set(k, q, sine * mp + cosine * mq);
  }
}

}  // namespace

SymmetricMatrix SymmetricMatrix::identity(std::size_t size) {
  SymmetricMatrix matrix(size);
  for (std::size_t i = 0; i < size; ++i) matrix.set(i, i, 1.0);
  return matrix;
}

EigenDecomposition eigen_decomposition(const SymmetricMatrix& symmetric) {
  constexpr int kMaxSweeps = 60;
  constexpr double kNegligible = 1e-24;
  SymmetricMatrix matrix = symmetric;
  const std::size_t size = matrix.size();
  EigenDecomposition result{ColumnVectors(size), std::vector<double>(size)};
  for (std::size_t i = 0; i < size; ++i) result.vectors(i, i) = 1.0;

  for (int sweep = 0; sweep < kMaxSweeps && off_diagonal(matrix) > kNegligible; ++sweep) {
    for (std::size_t q = 1; q < size; ++q) {
      for (std::size_t p = 0; p < q; ++p) {
        if (matrix(p, q) != 0.0) rotate(matrix, result.vectors, p, q);
      }
    }
  }

  constexpr double kMinEigenvalue = 1e-20;
  for (std::size_t i = 0; i < size; ++i) {
    result.roots[i] = std::sqrt(std::max(kMinEigenvalue, matrix(i, i)));
  }
  return result;
}

}  // namespace cls::tournament
