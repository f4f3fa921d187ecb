#include "assembly/mass_weighted.hpp"

#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <scree/response/modes.hpp>

namespace scree::response {

Modes modes_of(const LinearSystem& system) {
  const MassWeighted weighted(system);
  const Eigen::MatrixXd stiffness = weighted.stiffness();
  const Eigen::MatrixXd difference = stiffness - stiffness.transpose();
  const Eigen::MatrixXd symmetric = stiffness - 0.5 * difference;
  std::vector<Eigen::Index> heavy, massless;
  for (Eigen::Index i = 0; i < system.mass.size(); ++i) (system.mass[i] > 0 ? heavy : massless).push_back(i);
  // Without inertia, 0 = K_mm q_m + K_mh q_h.
  const Eigen::MatrixXd following =
      massless.empty()
          ? Eigen::MatrixXd(0, Eigen::Index(heavy.size()))
          : Eigen::MatrixXd(
                -symmetric(massless, massless).eval().fullPivLu().solve(symmetric(massless, heavy).eval()));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(symmetric(heavy, heavy) +
                                                             symmetric(heavy, massless) * following);
  Eigen::MatrixXd shape(system.mass.size(), Eigen::Index(heavy.size()));
  shape(heavy, Eigen::all) = modes.eigenvectors();
  shape(massless, Eigen::all) = following * modes.eigenvectors();
  return {modes.eigenvalues(), weighted.inverse_root().asDiagonal() * shape,
          stiffness.norm() > 0 ? difference.norm() / stiffness.norm() : 0};
}

}  // namespace scree::response
