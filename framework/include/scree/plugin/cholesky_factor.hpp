#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace scree {

// The Cholesky factor L of a Gram matrix, by rows of its lower triangle. A column that is a combination of
// earlier ones, to within `least` of its square, is left out: its row is 0, and it has no part in any
// solution.
class CholeskyFactor {
 public:
  static constexpr double least = 1e-9;
  // Numbers in the lower triangle of a matrix with so many columns.
  static std::size_t size(std::size_t columns) { return columns * (columns + 1) / 2; }

  // gram: lower triangle by rows.
  CholeskyFactor(const double* gram, std::size_t columns) : factor_(gram, gram + size(columns)) {
    for (std::size_t i = 0; i < columns; ++i) {
      double* row = factor_.data() + size(i);
      const double square = row[i];
      for (std::size_t j = 0; j <= i; ++j) {
        const double* other = factor_.data() + size(j);
        for (std::size_t k = 0; k < j; ++k) row[j] -= row[k] * other[k];
        if (j < i) row[j] = other[j] > 0 ? row[j] / other[j] : 0;
      }
      if (row[i] > least * square)
        row[i] = std::sqrt(row[i]);
      else
        std::fill(row, row + i + 1, 0.0);
    }
  }

  // False for a column that was left out.
  bool has(std::size_t column) const { return at(column, column) > 0; }

  // Solves L z = b.
  std::vector<double> forward(const std::vector<double>& b) const {
    std::vector<double> z(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
      if (!has(i)) continue;
      double rest = b[i];
      for (std::size_t k = 0; k < i; ++k) rest -= at(i, k) * z[k];
      z[i] = rest / at(i, i);
    }
    return z;
  }

  // Solves Lᵀ x = z for the first `columns`.
  std::vector<double> backward(const std::vector<double>& z, std::size_t columns) const {
    std::vector<double> x(columns);
    for (std::size_t i = columns; i-- > 0;) {
      if (!has(i)) continue;
      double rest = z[i];
      for (std::size_t k = i + 1; k < columns; ++k) rest -= at(k, i) * x[k];
      x[i] = rest / at(i, i);
    }
    return x;
  }

 private:
  double at(std::size_t row, std::size_t column) const { return factor_[size(row) + column]; }

  std::vector<double> factor_;
};

}  // namespace scree
