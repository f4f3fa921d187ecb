#include "band/backend/galerkin_basis.hpp"

#include <cmath>
#include <complex>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using namespace scree::response;
using Complex = std::complex<double>;
using Matrix = Eigen::MatrixXcd;

namespace {

constexpr Complex i(0, 1);
constexpr Eigen::Index size = 12;

Eigen::MatrixXd dense(double seed) {
  return Eigen::MatrixXd::NullaryExpr(size, size, [seed](Eigen::Index r, Eigen::Index c) {
    return std::sin(seed + 1.7 * double(r * r) + 0.9 * double(c)) + (r == c ? 8 : 0);
  });
}

Matrix columns(double seed, Eigen::Index count) {
  return Matrix::NullaryExpr(size, count, [seed](Eigen::Index r, Eigen::Index c) {
    return std::polar(1.0, seed + 2.3 * double(r) + 0.7 * double(c * c + r * c));
  });
}

// A system whose matrices are not symmetric, with one unknown without mass.
struct System {
  Eigen::SparseMatrix<double> stiffness = dense(1).sparseView(), damping = dense(2).sparseView();
  Eigen::VectorXd mass = Eigen::VectorXd::LinSpaced(size, 0, 1);

  Matrix at(double omega) const {
    return Matrix(stiffness) + i * omega * Matrix(damping) - omega * omega * Matrix(mass.asDiagonal());
  }
  GalerkinBasis basis(Eigen::Index capacity) const { return {stiffness, damping, mass, capacity}; }
};

}  // namespace

// Round-off of sums of twelve terms.
TEST_CASE("the vectors of a basis are orthonormal and span what was added", "[response]") {
  const System system;
  GalerkinBasis basis = system.basis(8);
  const Matrix first = columns(0.3, 3), second = columns(1.9, 2);
  basis.extend(first);
  basis.extend(second);
  CHECK(basis.size() == 5);
  CHECK(basis.room() == 3);
  const Matrix v = basis.vectors(Matrix::Identity(5, 5));
  CHECK((v.adjoint() * v - Matrix::Identity(5, 5)).norm() < 1e-14);
  for (const Matrix& added : {first, second}) CHECK((added - v * (v.adjoint() * added)).norm() < 1e-13);
}

TEST_CASE("directions that a basis has already are not added, nor more than there is room for",
          "[response]") {
  const System system;
  GalerkinBasis basis = system.basis(4);
  const Matrix first = columns(0.3, 3);
  basis.extend(first);
  Matrix twice(size, 2);  // the same new direction twice
  twice << columns(1.9, 1), columns(1.9, 1);
  basis.extend(twice);
  CHECK(basis.size() == 4);
  basis.extend(columns(5, 3));
  CHECK(basis.size() == 4);
}

// The equations projected on V: Vᴴ (f − A V y) = 0.
TEST_CASE("coefficients solve the projected equations, in the whole space the equations themselves",
          "[response]") {
  const System system;
  const double omega = 1.3;
  const Matrix load = columns(0.8, 1);
  GalerkinBasis few = system.basis(5);
  few.extend(columns(0.3, 5));
  const Matrix v = few.vectors(Matrix::Identity(5, 5));
  const Matrix y = few.coefficients(omega, load.col(0));
  const Matrix rest = load - system.at(omega) * (v * y);
  CHECK((v.adjoint() * rest).norm() < 1e-12);
  CHECK((few.residuals(Eigen::VectorXd::Constant(1, omega), load, y) - rest).norm() < 1e-12);

  GalerkinBasis all = system.basis(size);
  all.extend(columns(0.3, 5));
  all.extend(Matrix::Identity(size, size).leftCols(7));
  REQUIRE(all.size() == size);
  const Matrix solution = all.vectors(all.coefficients(omega, load.col(0)));
  CHECK((solution - system.at(omega).partialPivLu().solve(load)).norm() < 1e-12);
}
