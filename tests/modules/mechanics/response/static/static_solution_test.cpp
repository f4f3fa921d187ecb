#include "static/static_solution.hpp"

#include <cmath>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using namespace scree::response;

namespace {

constexpr Eigen::Index static_size = 24;

Eigen::MatrixXd static_matrix(double seed) {
  return Eigen::MatrixXd::NullaryExpr(static_size, static_size, [seed](Eigen::Index r, Eigen::Index c) {
    return std::sin(seed + 1.3 * double(r * r) + 2.1 * double(c));
  });
}

}  // namespace

// In the coordinates √M q K is not symmetric, has eigenvalues from 1 to 24 and a tenth of antisymmetric part.
// The iteration goes on to round-off, 1e-13.
TEST_CASE("static displacements are those of a dense solution", "[response]") {
  const Eigen::MatrixXd basis = Eigen::HouseholderQR<Eigen::MatrixXd>(static_matrix(1)).householderQ();
  Eigen::MatrixXd a = 0.1 * (static_matrix(2) - static_matrix(2).transpose());
  a.diagonal() += Eigen::VectorXd::LinSpaced(static_size, 1, 24);
  const Eigen::MatrixXd weighted = basis * a * basis.transpose();
  const Eigen::VectorXd mass = Eigen::VectorXd::LinSpaced(static_size, 1, 3), root = mass.cwiseSqrt();
  const LinearSystem system{
      .freedom = DegreesOfFreedom(2, 0, std::vector<bool>(static_size / 2, true),
                                  std::vector<bool>(static_size / 2, false)),
      .stiffness = Eigen::MatrixXd(root.asDiagonal() * weighted * root.asDiagonal()).sparseView(),
      .damping = Eigen::SparseMatrix<double>(static_size, static_size),
      .mass = mass,
      .wall_stiffness = Eigen::SparseMatrix<double>(static_size, 0),
      .wall_damping = Eigen::SparseMatrix<double>(static_size, 0),
      .wall_mass = Eigen::SparseMatrix<double>(static_size, 0),
      .rattlers = {}};
  const UndampedSystem undamped(system);
  const auto inverse = undamped.factorise(-undamped.rounding());
  const Eigen::VectorXd force = static_matrix(3).col(0);
  const StaticSolution solution = solve_static(undamped, *inverse, Eigen::MatrixXd(static_size, 0), force);
  const Eigen::VectorXd exact = Eigen::MatrixXd(system.stiffness).partialPivLu().solve(force);
  CHECK((solution.displacement - exact).norm() / exact.norm() < 1e-11);
  CHECK(solution.residual < 1e-12);
}
