#include "triangle.hpp"

#include <algorithm>
#include <cmath>

namespace scree::signals {

Triangle::Triangle(const double* gram, std::size_t columns) : factor_(gram, gram + size(columns)) {
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

std::vector<double> Triangle::forward(const std::vector<double>& b) const {
  std::vector<double> z(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (!has(i)) continue;
    double rest = b[i];
    for (std::size_t k = 0; k < i; ++k) rest -= at(i, k) * z[k];
    z[i] = rest / at(i, i);
  }
  return z;
}

std::vector<double> Triangle::backward(const std::vector<double>& z, std::size_t columns) const {
  std::vector<double> x(columns);
  for (std::size_t i = columns; i-- > 0;) {
    if (!has(i)) continue;
    double rest = z[i];
    for (std::size_t k = i + 1; k < columns; ++k) rest -= at(k, i) * x[k];
    x[i] = rest / at(i, i);
  }
  return x;
}

}  // namespace scree::signals
