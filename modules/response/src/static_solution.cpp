#include "static_solution.hpp"

#include "mass_weighted.hpp"

#include <Eigen/QR>

namespace scree::response {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

constexpr int most_directions = 40, most_restarts = 10;
constexpr double round_off = 1e-15;  // of the residual over the force
// A restart that does not reduce the residual by this factor found nothing but round-off.
constexpr double least_gain = 0.5;

// The x of the least residual |r − K x| in a Krylov space of K and its approximate inverse.
Vector correction(const Eigen::SparseMatrix<double>& stiffness, const ShiftedFactors& inverse,
                  const Vector& r, double tolerance) {
  const Index most = std::min<Index>(most_directions, r.size());
  Matrix basis(r.size(), most + 1), directions(r.size(), most), projected = Matrix::Zero(most + 1, most);
  const double length = r.norm();
  basis.col(0) = r / length;
  for (Index k = 0; k < most; ++k) {
    Vector x = basis.col(k);
    inverse.solve(x.data(), 1);
    directions.col(k) = x;
    Vector product = stiffness * x;
    for (int pass = 0; pass < 2; ++pass) {
      const Vector shares = basis.leftCols(k + 1).transpose() * product;
      product -= basis.leftCols(k + 1) * shares;
      projected.col(k).head(k + 1) += shares;
    }
    projected(k + 1, k) = product.norm();
    const auto part = projected.topLeftCorner(k + 2, k + 1);
    const Vector first = length * Vector::Unit(k + 2, 0);
    const Vector coefficients = part.colPivHouseholderQr().solve(first);
    const bool found = (first - part * coefficients).norm() <= tolerance;
    if (found || k + 1 == most || !(projected(k + 1, k) > 0))
      return directions.leftCols(k + 1) * coefficients;
    basis.col(k + 1) = product / projected(k + 1, k);
  }
  return Vector::Zero(r.size());
}

}  // namespace

StaticSolution solve_static(const UndampedSystem& system, const ShiftedFactors& inverse,
                            const Eigen::VectorXd& force) {
  const Eigen::SparseMatrix<double>& stiffness = system.weighted().stiffness();
  const Vector load = system.weighted().inverse_root().asDiagonal() * force;
  Vector x = Vector::Zero(load.size()), residual = load;
  if (load.norm() == 0) return {x, 0};
  for (int restart = 0; restart < most_restarts; ++restart) {
    const Vector better = x + correction(stiffness, inverse, residual, round_off * load.norm());
    const Vector rest = load - stiffness * better;
    if (!(rest.norm() < residual.norm())) break;
    const bool gained = rest.norm() < least_gain * residual.norm();
    x = better, residual = rest;
    if (!gained) break;
  }
  return {system.weighted().inverse_root().asDiagonal() * x, residual.norm() / load.norm()};
}

}  // namespace scree::response
