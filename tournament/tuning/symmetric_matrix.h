// Small symmetric matrices and their eigenvectors.
#pragma once

#include <cstddef>
#include <vector>

namespace cls::tournament {

/// A square matrix; `set` keeps it symmetric.
class SymmetricMatrix {
 public:
  explicit SymmetricMatrix(std::size_t size) : size_(size), cells_(size * size) {}
  static SymmetricMatrix identity(std::size_t size);

  std::size_t size() const { return size_; }
  double operator()(std::size_t row, std::size_t column) const {
    return cells_[row * size_ + column];
  }
  void set(std::size_t row, std::size_t column, double value) {
    cells_[row * size_ + column] = value;
    cells_[column * size_ + row] = value;
  }

 private:
  std::size_t size_;
  std::vector<double> cells_;
};

/// The columns of a square matrix.
class ColumnVectors {
 public:
  explicit ColumnVectors(std::size_t size) : size_(size), cells_(size * size) {}
  double operator()(std::size_t row, std::size_t column) const {
    return cells_[row * size_ + column];
  }
  double& operator()(std::size_t row, std::size_t column) { return cells_[row * size_ + column]; }

 private:
  std::size_t size_;
  std::vector<double> cells_;
};

/// Eigenvectors as columns, and the square roots of their eigenvalues, which are at least 1e-10.
struct EigenDecomposition {
  ColumnVectors vectors;
  std::vector<double> roots;
};

/// Decomposes a positive semidefinite matrix by Jacobi rotations.
EigenDecomposition eigen_decomposition(const SymmetricMatrix& matrix);

}  // namespace cls::tournament
