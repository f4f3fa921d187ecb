#include "mass_weighted.hpp"

#include <Eigen/Eigenvalues>

#include <scree/response/modes.hpp>

namespace scree::response {

Modes modes_of(const LinearSystem& system) {
  const Eigen::MatrixXd stiffness = MassWeighted(system).stiffness();
  const Eigen::MatrixXd difference = stiffness - stiffness.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness - 0.5 * difference);
  const Eigen::VectorXd inverse_root = system.mass.cwiseSqrt().cwiseInverse();
  return {modes.eigenvalues(), inverse_root.asDiagonal() * modes.eigenvectors(),
          stiffness.norm() > 0 ? difference.norm() / stiffness.norm() : 0};
}

}  // namespace scree::response
