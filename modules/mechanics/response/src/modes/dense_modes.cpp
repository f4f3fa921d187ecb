#include "assembly/mass_weighted.hpp"

#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <scree/response/found_modes.hpp>

namespace scree::response {

Modes modes_of(const LinearSystem& system) {
  const MassWeighted weighted(system);
  const Eigen::MatrixXd stiffness = weighted.stiffness();
  const Eigen::MatrixXd difference = stiffness - stiffness.transpose();
  const Eigen::MatrixXd symmetric = stiffness - 0.5 * difference;
  std::vector<Eigen::Index> with_mass, without_mass;
  for (Eigen::Index i = 0; i < system.mass.size(); ++i)
    (system.mass[i] > 0 ? with_mass : without_mass).push_back(i);
  // Not the vectors themselves: GCC 12 reports frees of foreign memory where Eigen copies them.
  using Indices = Eigen::Map<const Eigen::Array<Eigen::Index, Eigen::Dynamic, 1>>;
  const Indices heavy(with_mass.data(), Eigen::Index(with_mass.size())),
      massless(without_mass.data(), Eigen::Index(without_mass.size()));
  // Without inertia, 0 = K_mm q_m + K_mh q_h.
  const Eigen::MatrixXd following =
      massless.size() == 0
          ? Eigen::MatrixXd(0, heavy.size())
          : Eigen::MatrixXd(
                -symmetric(massless, massless).eval().fullPivLu().solve(symmetric(massless, heavy).eval()));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(symmetric(heavy, heavy) +
                                                             symmetric(heavy, massless) * following);
  Eigen::MatrixXd shape(system.mass.size(), heavy.size());
  shape(heavy, Eigen::all) = modes.eigenvectors();
  shape(massless, Eigen::all) = following * modes.eigenvectors();
  return {modes.eigenvalues(), weighted.inverse_root().asDiagonal() * shape,
          stiffness.norm() > 0 ? difference.norm() / stiffness.norm() : 0};
}

}  // namespace scree::response
