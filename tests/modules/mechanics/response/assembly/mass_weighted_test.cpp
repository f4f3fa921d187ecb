#include "assembly/mass_weighted.hpp"

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

Eigen::MatrixXd weighted_matrix(double seed, Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [seed](Eigen::Index r, Eigen::Index c) {
    return std::sin(seed + 1.3 * double(r) + 2.1 * double(c * c)) + (r == c ? 4 : 0);
  });
}

// Two translations of a disc, with a mass, and a wall without one that a force moves, whose viscosity is a
// part of C.
LinearSystem system_with_step(double time_step) {
  LinearSystem system{.freedom = DegreesOfFreedom(2, 0, {true}, {false}, {true}),
                      .stiffness = weighted_matrix(1, 3, 3).sparseView(),
                      .damping = weighted_matrix(2, 3, 3).sparseView(),
                      .mass = Eigen::Vector3d(2, 2, 0),
                      .wall_stiffness = weighted_matrix(3, 3, 2).sparseView(),
                      .wall_damping = weighted_matrix(4, 3, 2).sparseView(),
                      .wall_mass = Eigen::SparseMatrix<double>(3, 2),
                      .rattlers = {},
                      .time_step = time_step};
  system.wall_viscosity = Eigen::Vector3d(0, 0, 0.7);
  return system;
}

}  // namespace

// Round-off of some products: 1e-14.
TEST_CASE("in the coordinates of a weighted system the dynamic stiffness is that of the system",
          "[response]") {
  const LinearSystem system = system_with_step(0);
  const MassWeighted weighted(system);
  const double omega = 1.7;
  const DenseComplex expected = DenseComplex(system.stiffness) +
                                imaginary_unit * omega * DenseComplex(system.damping) -
                                omega * omega * DenseComplex(system.mass.asDiagonal());
  const auto root = weighted.inverse_root().cwiseInverse().asDiagonal();
  CHECK((root * DenseComplex(weighted.dynamic_stiffness(omega)) * root - expected).norm() < 1e-13);
  CHECK(weighted.inverse_root()[0] == Approx(1 / std::sqrt(2)));
  // A mass of 0 is replaced by one that gives the largest of the other diagonal elements.
  const Eigen::VectorXd diagonal = Eigen::MatrixXd(weighted.stiffness()).diagonal();
  CHECK(diagonal[2] == Approx(diagonal.head(2).maxCoeff()));
  CHECK(weighted.nearest_omega(omega) == omega);

  Drive drive;
  drive.force = Eigen::Vector3cd(1, -2.0 * imaginary_unit, 0.5);
  drive.walls = Eigen::Vector2cd(0.3, imaginary_unit);
  const Eigen::VectorXcd load = drive.force - (DenseComplex(system.wall_stiffness) +
                                               imaginary_unit * omega * DenseComplex(system.wall_damping)) *
                                                  drive.walls;
  CHECK((root * weighted.load(drive, omega) - load).norm() < 1e-14);
  const Eigen::VectorXcd q = expected.partialPivLu().solve(load);
  CHECK((weighted.amplitude(root * q) - q).norm() < 1e-14);
}

// Velocity Verlet with x_n = z^n: v_n = (x_(n+1) − x_(n−1))/(2h), a_n = (x_(n+1) − 2 x_n + x_(n−1))/h².
// Dashpots see v_(n−1) + h a_(n−1); a wall without mass moves by (x_n − x_(n−1))/h, a viscosity acts on v_n
// where there is a mass.
TEST_CASE("with a time step the dynamic stiffness is that of the steps", "[response]") {
  const double h = 0.11, omega = 2.3;
  const LinearSystem system = system_with_step(h);
  const MassWeighted weighted(system);
  const Complex z = std::exp(imaginary_unit * omega * h), before = 1.0 / z;
  const Complex acceleration = (z - 2.0 + before) / (h * h);
  const Complex seen = ((z - before) / (2 * h) + h * acceleration) * before, slow = (1.0 - before) / h;
  DenseComplex expected =
      DenseComplex(system.stiffness) + acceleration * DenseComplex(system.mass.asDiagonal());
  expected.leftCols(2) += seen * DenseComplex(system.damping).leftCols(2);
  expected.col(2) += slow * DenseComplex(system.damping).col(2);
  expected(2, 2) += system.wall_viscosity[2] * ((z - before) / (2 * h) - seen);
  const auto root = weighted.inverse_root().cwiseInverse().asDiagonal();
  CHECK((root * DenseComplex(weighted.dynamic_stiffness(omega)) * root - expected).norm() < 1e-12);

  const double nearest = weighted.nearest_omega(omega);
  const Eigen::MatrixXd stiffness = weighted.stiffness(), damping = weighted.damping();
  const Eigen::Vector3d inertia(1, 1, 0);
  const DenseComplex continuous = DenseComplex(stiffness) + imaginary_unit * nearest * DenseComplex(damping) -
                                  nearest * nearest * DenseComplex(inertia.asDiagonal());
  const Eigen::Vector3cd q(1, imaginary_unit, -0.4);
  CHECK((weighted.difference(omega, q) - (DenseComplex(weighted.dynamic_stiffness(omega)) - continuous) * q)
            .norm() < 1e-12);
}

TEST_CASE("a drive of another size is refused", "[response]") {
  const LinearSystem system = system_with_step(0);
  Drive drive;
  drive.walls = Eigen::VectorXcd::Ones(3);
  CHECK_THROWS_WITH(MassWeighted(system).load(drive, 1), "Drive::walls has 3 components; give 2 or none");
}
