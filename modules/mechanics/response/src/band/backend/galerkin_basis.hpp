#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>

namespace scree::response {

// Orthonormal vectors V in whose span (K + iωC − ω²M) q = f is solved, with their products with the matrices.
class GalerkinBasis {
 public:
  using Matrix = Eigen::MatrixXcd;
  using Sparse = Eigen::SparseMatrix<double>;

  GalerkinBasis(const Sparse& stiffness, const Sparse& damping, const Eigen::VectorXd& mass,
                Eigen::Index capacity);

  Eigen::Index size() const { return size_; }
  Eigen::Index room() const { return vectors_.cols() - size_; }
  // Adds the directions of unit columns that are not yet in the span, at most room() of them.
  void extend(Matrix columns);
  // Coefficients y of q = V y, from the equations projected on V.
  Eigen::VectorXcd coefficients(double omega, const Eigen::VectorXcd& load) const;
  Matrix vectors(const Matrix& coefficients) const;
  // f − A q for each column.
  Matrix residuals(const Eigen::VectorXd& omega, const Matrix& loads, const Matrix& coefficients) const;

 private:
  auto span() const { return vectors_.leftCols(size_); }
  void remove_span(Matrix& columns) const;

  const Sparse &stiffness_, &damping_;
  const Eigen::VectorXd& mass_;
  Eigen::Index size_ = 0;
  Matrix vectors_, of_stiffness_, of_damping_;        // V, K V, C V
  Matrix stiffness_part_, damping_part_, mass_part_;  // Vᴴ K V, ...
};

}  // namespace scree::response
