#pragma once

#include <complex>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace scree::test {

using Complex = std::complex<double>;
using DenseComplex = Eigen::MatrixXcd;
using Sparse = Eigen::SparseMatrix<double>;

inline constexpr Complex imaginary_unit(0, 1);

}  // namespace scree::test
