#include "band/backend/galerkin_basis.hpp"

#include "matrices.hpp"

#include <cmath>
#include <complex>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using namespace scree::response;
using scree::test::Complex;
using scree::test::DenseComplex;
using scree::test::imaginary_unit;

namespace {

constexpr Eigen::Index system_size = 12;

Eigen::MatrixXd galerkin_matrix(double seed) {
  return Eigen::MatrixXd::NullaryExpr(system_size, system_size, [seed](Eigen::Index r, Eigen::Index c) {
    return std::sin(seed + 1.7 * double(r * r) + 0.9 * double(c)) + (r == c ? 8 : 0);
  });
}

DenseComplex columns(double seed, Eigen::Index count) {
  return DenseComplex::NullaryExpr(system_size, count, [seed](Eigen::Index r, Eigen::Index c) {
    return std::polar(1.0, seed + 2.3 * double(r) + 0.7 * double(c * c + r * c));
  });
}

// A system whose matrices are not symmetric, with one unknown without mass.
struct System {
  Eigen::SparseMatrix<double> stiffness = galerkin_matrix(1).sparseView(),
                              damping = galerkin_matrix(2).sparseView();
  Eigen::VectorXd mass = Eigen::VectorXd::LinSpaced(system_size, 0, 1);

  DenseComplex at(double omega) const {
    return DenseComplex(stiffness) + imaginary_unit * omega * DenseComplex(damping) -
           omega * omega * DenseComplex(mass.asDiagonal());
  }
  GalerkinBasis basis(Eigen::Index capacity) const { return {stiffness, damping, mass, capacity}; }
};

}  // namespace

// Round-off of sums of twelve terms.
TEST_CASE("the vectors of a basis are orthonormal and span what was added", "[response]") {
  const System system;
  GalerkinBasis basis = system.basis(8);
  const DenseComplex first = columns(0.3, 3), second = columns(1.9, 2);
  basis.extend(first);
  basis.extend(second);
  CHECK(basis.size() == 5);
  CHECK(basis.room() == 3);
  const DenseComplex v = basis.vectors(DenseComplex::Identity(5, 5));
  CHECK((v.adjoint() * v - DenseComplex::Identity(5, 5)).norm() < 1e-14);
  for (const DenseComplex& added : {first, second}) CHECK((added - v * (v.adjoint() * added)).norm() < 1e-13);
}

TEST_CASE("directions that a basis has already are not added, nor more than there is room for",
          "[response]") {
  const System system;
  GalerkinBasis basis = system.basis(4);
  const DenseComplex first = columns(0.3, 3);
  basis.extend(first);
  DenseComplex twice(system_size, 2);  // the same new direction twice
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
  const DenseComplex load = columns(0.8, 1);
  GalerkinBasis few = system.basis(5);
  few.extend(columns(0.3, 5));
  const DenseComplex v = few.vectors(DenseComplex::Identity(5, 5));
  const DenseComplex y = few.coefficients(omega, load.col(0));
  const DenseComplex rest = load - system.at(omega) * (v * y);
  CHECK((v.adjoint() * rest).norm() < 1e-12);
  CHECK((few.residuals(Eigen::VectorXd::Constant(1, omega), load, y) - rest).norm() < 1e-12);

  GalerkinBasis all = system.basis(system_size);
  all.extend(columns(0.3, 5));
  all.extend(DenseComplex::Identity(system_size, system_size).leftCols(7));
  REQUIRE(all.size() == system_size);
  const DenseComplex solution = all.vectors(all.coefficients(omega, load.col(0)));
  CHECK((solution - system.at(omega).partialPivLu().solve(load)).norm() < 1e-12);
}
