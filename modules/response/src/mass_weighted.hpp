#pragma once

#include <complex>

#include <Eigen/SparseCore>

#include <scree/response/frequency_response.hpp>
#include <scree/response/linear_system.hpp>

namespace scree::response {

using ComplexMatrix = Eigen::SparseMatrix<std::complex<double>>;

// A system in the coordinates √S q, in which translations and rotations have the same unit. S is M; where M is 0,
// it is the mass that gives the diagonal of S^−½ K S^−½ its largest other value.
class MassWeighted {
 public:
  explicit MassWeighted(const LinearSystem& system);

  const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }
  const Eigen::SparseMatrix<double>& damping() const { return damping_; }
  const Eigen::VectorXd& inverse_root() const { return inverse_root_; }  // S^−½
  // K + iωC − ω²M, ω in rad/s. It has the same pattern at all frequencies.
  ComplexMatrix dynamic_stiffness(double omega) const;
  // The right-hand side f. Throws Error if the drive has another size.
  Eigen::VectorXcd load(const Drive& drive, double omega) const;
  // q of √S q.
  Eigen::VectorXcd amplitude(const Eigen::VectorXcd& weighted) const;

 private:
  const LinearSystem& system_;
  Eigen::VectorXd inverse_root_;
  Eigen::SparseMatrix<double> stiffness_, damping_, mass_;
};

}  // namespace scree::response
