#pragma once

#include <complex>

#include <Eigen/SparseCore>

#include <scree/response/frequency_response.hpp>
#include <scree/response/harmonic_rates.hpp>
#include <scree/response/linear_system.hpp>

namespace scree::response {

using ComplexMatrix = Eigen::SparseMatrix<std::complex<double>>;

// A system in the coordinates √S q, in which translations and rotations have the same unit. S is M; where M
// is 0, S is the mass with which that diagonal element of S^−½ K S^−½ equals the largest of the others.
class MassWeighted {
 public:
  explicit MassWeighted(const LinearSystem& system);

  const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }
  const Eigen::SparseMatrix<double>& damping() const { return damping_; }
  const Eigen::VectorXd& inverse_root() const { return inverse_root_; }  // S^−½
  // K + iωC − ω²M, ω in rad/s, or its equivalent with the time step of the system. The pattern is the same at
  // all frequencies.
  ComplexMatrix dynamic_stiffness(double omega) const;
  // The ω of continuous time whose matrix is nearest to dynamic_stiffness(omega), and the product of the
  // difference with a vector; 0 without a time step.
  double nearest_omega(double omega) const;
  Eigen::VectorXcd difference(double omega, const Eigen::VectorXcd& q) const;
  bool has_time_step() const { return system_.time_step > 0; }
  // The right-hand side f. Throws Error if the drive has another size, or, with a time step, moves a wall
  // that has a mass.
  Eigen::VectorXcd load(const Drive& drive, double omega) const;
  // q of √S q.
  Eigen::VectorXcd amplitude(const Eigen::VectorXcd& weighted) const;

 private:
  // The rate of the velocity in each column of C, and the further terms of the viscosity of walls.
  Eigen::VectorXcd velocity_rates(const HarmonicRates& rates) const;
  Eigen::VectorXcd viscous_terms(const HarmonicRates& rates) const;

  const LinearSystem& system_;
  Eigen::VectorXd inverse_root_;
  Eigen::SparseMatrix<double> stiffness_, damping_, mass_;
};

}  // namespace scree::response
