#pragma once

#include <cstddef>
#include <vector>

namespace scree::signals {

// The Cholesky factor of a Gram matrix, by rows of its lower triangle. A column that is a combination of earlier ones, to
// within `least` of its square, is left out: its row is 0 and it takes no part in what follows.
class Triangle {
 public:
  static constexpr double least = 1e-9;
  static std::size_t size(std::size_t columns) { return columns * (columns + 1) / 2; }

  // gram: lower triangle by rows.
  Triangle(const double* gram, std::size_t columns);

  bool has(std::size_t column) const { return at(column, column) > 0; }
  // Solves L z = b.
  std::vector<double> forward(const std::vector<double>& b) const;
  // Solves L^T x = z for the first `columns`.
  std::vector<double> backward(const std::vector<double>& z, std::size_t columns) const;

 private:
  double at(std::size_t row, std::size_t column) const { return factor_[size(row) + column]; }

  std::vector<double> factor_;
};

}  // namespace scree::signals
