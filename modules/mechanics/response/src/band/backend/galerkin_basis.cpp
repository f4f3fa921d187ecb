#include "band/backend/galerkin_basis.hpp"

#include <algorithm>
#include <complex>

namespace scree::response {

namespace {

// Directions closer to the span, or to each other, than this angle are left out: they add work and little
// else. If they matter, they return in the next residuals.
constexpr double smallest_angle = 0.03;

using Matrix = GalerkinBasis::Matrix;
using Columns = Eigen::Ref<const Matrix>;

// Products of complex matrices, instantiated once: one instance for each type of expression takes seconds to
// compile.
Matrix product(const Columns& a, const Columns& b) { return a * b; }
Matrix adjoint_product(const Columns& a, const Columns& b) { return a.adjoint() * b; }

Matrix product(const GalerkinBasis::Sparse& a, const Matrix& x) {
  Matrix result(x.rows(), x.cols());
  result.real() = a * Eigen::MatrixXd(x.real());
  result.imag() = a * Eigen::MatrixXd(x.imag());
  return result;
}

}  // namespace

GalerkinBasis::GalerkinBasis(const Sparse& stiffness, const Sparse& damping, const Eigen::VectorXd& mass,
                             Eigen::Index capacity)
    : stiffness_(stiffness),
      damping_(damping),
      mass_(mass),
      vectors_(mass.size(), capacity),
      of_stiffness_(mass.size(), capacity),
      of_damping_(mass.size(), capacity),
      stiffness_part_(capacity, capacity),
      damping_part_(capacity, capacity),
      mass_part_(capacity, capacity) {}

void GalerkinBasis::remove_span(Matrix& columns) const {
  if (size_ > 0) columns -= product(span(), adjoint_product(span(), columns));
}

void GalerkinBasis::extend(Matrix columns) {
  remove_span(columns);
  const Eigen::SelfAdjointEigenSolver<Matrix> principal(adjoint_product(columns, columns));
  const Eigen::VectorXd& squares = principal.eigenvalues();
  const double least = smallest_angle * smallest_angle * squares[squares.size() - 1];
  const Eigen::Index added =
      std::min<Eigen::Index>(room(), (squares.array() > std::max(least, 1e-300)).count());
  if (added == 0) return;
  const Matrix directions =
      principal.eigenvectors().rightCols(added) * squares.tail(added).cwiseSqrt().cwiseInverse().asDiagonal();
  Matrix more = product(columns, directions);
  // Removes what round-off has left of the span, then of each other.
  remove_span(more);
  const Eigen::LLT<Matrix> overlaps(adjoint_product(more, more));
  overlaps.matrixU().template solveInPlace<Eigen::OnTheRight>(more);

  const Eigen::Index from = size_, to = size_ + added;
  vectors_.middleCols(from, added) = more;
  of_stiffness_.middleCols(from, added) = product(stiffness_, more);
  of_damping_.middleCols(from, added) = product(damping_, more);
  size_ = to;
  stiffness_part_.block(0, from, to, added) = adjoint_product(span(), of_stiffness_.middleCols(from, added));
  damping_part_.block(0, from, to, added) = adjoint_product(span(), of_damping_.middleCols(from, added));
  mass_part_.block(0, from, to, added) = adjoint_product(span(), Matrix(mass_.asDiagonal() * more));
  stiffness_part_.block(from, 0, added, from) = adjoint_product(more, of_stiffness_.leftCols(from));
  damping_part_.block(from, 0, added, from) = adjoint_product(more, of_damping_.leftCols(from));
  mass_part_.block(from, 0, added, from) = mass_part_.block(0, from, from, added).adjoint();
}

Eigen::VectorXcd GalerkinBasis::coefficients(double omega, const Eigen::VectorXcd& load) const {
  const std::complex<double> i_omega(0, omega);
  const Matrix projected = stiffness_part_.topLeftCorner(size_, size_) +
                           i_omega * damping_part_.topLeftCorner(size_, size_) -
                           omega * omega * mass_part_.topLeftCorner(size_, size_);
  return projected.partialPivLu().solve(adjoint_product(span(), load).col(0));
}

Matrix GalerkinBasis::vectors(const Matrix& coefficients) const { return product(span(), coefficients); }

Matrix GalerkinBasis::residuals(const Eigen::VectorXd& omega, const Matrix& loads,
                                const Matrix& coefficients) const {
  const std::complex<double> i(0, 1);
  const Matrix velocities = coefficients * (i * omega).asDiagonal();
  const Matrix accelerations = coefficients * (-omega.cwiseAbs2()).asDiagonal();
  return loads - product(of_stiffness_.leftCols(size_), coefficients) -
         product(of_damping_.leftCols(size_), velocities) -
         mass_.asDiagonal() * product(span(), accelerations);
}

}  // namespace scree::response
