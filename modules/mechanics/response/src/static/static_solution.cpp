#include "static/static_solution.hpp"

#include "assembly/mass_weighted.hpp"

#include <Eigen/QR>

namespace scree::response {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

constexpr int most_directions = 40, most_gmres_restarts = 20;
// Wanted reduction of the residual per restart, and the smallest reduction that is not round-off.
constexpr double wanted_gain = 1e-4, smallest_gain = 0.5;

// GMRES across the floppy modes, in the coordinates √M q.
class Solver {
 public:
  Solver(const UndampedSystem& system, const ShiftedFactors& inverse, const Matrix& floppy)
      : stiffness_(system.weighted().stiffness()), inverse_(inverse) {
    if (floppy.cols() == 0) return;
    const Matrix weighted = system.weighted().inverse_root().cwiseInverse().asDiagonal() * floppy;
    floppy_ = Eigen::HouseholderQR<Matrix>(weighted).householderQ() *
              Matrix::Identity(floppy.rows(), floppy.cols());
  }

  Vector solve(const Vector& load) const {
    Vector x = Vector::Zero(load.size()), residual = across_floppy(load);
    for (int restart = 0; restart < most_gmres_restarts && residual.norm() > 0; ++restart) {
      const Vector better = x + correction(residual);
      const Vector rest = across_floppy(load - stiffness_ * better);
      const bool gained = rest.norm() < smallest_gain * residual.norm();
      if (rest.norm() < residual.norm()) {
        x = better;
        residual = rest;
      }
      if (!gained) break;
    }
    return x;
  }

 private:
  Vector across_floppy(const Vector& x) const {
    if (floppy_.cols() == 0) return x;
    const Vector shares = floppy_.transpose() * x;
    return x - floppy_ * shares;
  }

  // The x with the smallest residual |r − K x| in a Krylov space of K and its approximate inverse.
  Vector correction(const Vector& r) const {
    const Index most = std::min<Index>(most_directions, r.size());
    Matrix basis(r.size(), most + 1), directions(r.size(), most), projected = Matrix::Zero(most + 1, most);
    const double length = r.norm();
    basis.col(0) = r / length;
    for (Index k = 0;; ++k) {
      Vector x = basis.col(k);
      inverse_.solve(x.data(), 1);
      directions.col(k) = across_floppy(x);
      Vector product = across_floppy(stiffness_ * directions.col(k));
      for (int pass = 0; pass < 2; ++pass) {
        const Vector shares = basis.leftCols(k + 1).transpose() * product;
        product -= basis.leftCols(k + 1) * shares;
        projected.col(k).head(k + 1) += shares;
      }
      projected(k + 1, k) = product.norm();
      const auto part = projected.topLeftCorner(k + 2, k + 1);
      const Vector first = length * Vector::Unit(k + 2, 0);
      const Vector coefficients = part.colPivHouseholderQr().solve(first);
      const bool found = (first - part * coefficients).norm() <= wanted_gain * length;
      if (found || k + 1 == most || !(projected(k + 1, k) > 0))
        return directions.leftCols(k + 1) * coefficients;
      basis.col(k + 1) = product / projected(k + 1, k);
    }
  }

  const Eigen::SparseMatrix<double>& stiffness_;
  const ShiftedFactors& inverse_;
  Matrix floppy_;  // orthonormal
};

}  // namespace

StaticSolution solve_static(const UndampedSystem& system, const ShiftedFactors& inverse,
                            const Eigen::MatrixXd& floppy, const Eigen::VectorXd& force) {
  const Vector& inverse_root = system.weighted().inverse_root();
  const Vector load = inverse_root.asDiagonal() * force;
  const Vector x = Solver(system, inverse, floppy).solve(load);
  const double scale = load.norm();
  const Vector rest = load - system.weighted().stiffness() * x;
  return {inverse_root.asDiagonal() * x, scale > 0 ? rest.norm() / scale : 0};
}

}  // namespace scree::response
