#pragma once

#include <complex>

#include <Eigen/SparseCore>

#include <scree/response/frequency_response.hpp>
#include <scree/response/linear_system.hpp>

namespace scree::response {

using ComplexMatrix = Eigen::SparseMatrix<std::complex<double>>;

// A system in the coordinates √M q, in which translations and rotations have the same unit.
class MassWeighted {
 public:
  explicit MassWeighted(const LinearSystem& system);

  const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }
  const Eigen::SparseMatrix<double>& damping() const { return damping_; }
  // K + iωC − ω², ω in rad/s. It has the same pattern at all frequencies.
  ComplexMatrix dynamic_stiffness(double omega) const;
  // The right-hand side f. Throws Error if the drive has another size.
  Eigen::VectorXcd load(const Drive& drive, double omega) const;
  // q of √M q.
  Eigen::VectorXcd amplitude(const Eigen::VectorXcd& weighted) const;

 private:
  const LinearSystem& system_;
  Eigen::VectorXd inverse_root_;
  Eigen::SparseMatrix<double> stiffness_, damping_, identity_;
};

}  // namespace scree::response
