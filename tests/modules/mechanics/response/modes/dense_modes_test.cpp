#include <cmath>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <scree/response/found_modes.hpp>

using namespace scree::response;

namespace {

// Two masses and a wall without one between three springs of 1, 2 and 4, the last to the ground;
// antisymmetric parts of K do not count.
LinearSystem chain_of_springs(double antisymmetric) {
  Eigen::Matrix3d stiffness;
  stiffness << 1, -1, 0, -1, 3, -2, 0, -2, 6;
  stiffness(0, 1) += antisymmetric, stiffness(1, 0) -= antisymmetric;
  return {.freedom = DegreesOfFreedom(2, 0, {true}, {false}, {true}),
          .stiffness = stiffness.sparseView(),
          .damping = Eigen::SparseMatrix<double>(3, 3),
          .mass = Eigen::Vector3d(2, 3, 0),
          .wall_stiffness = Eigen::SparseMatrix<double>(3, 2),
          .wall_damping = Eigen::SparseMatrix<double>(3, 2),
          .wall_mass = Eigen::SparseMatrix<double>(3, 2),
          .rattlers = {}};
}

}  // namespace

// The wall is displaced by a third of the second mass: springs of 1 and 8/6 = 4/3 to the ground, masses 2 and
// 3. 6 λ² − (3 + 14/3) λ + 4/3 = 0.
TEST_CASE("modes of masses with a wall without one are those of the springs in line", "[response]") {
  for (const double antisymmetric : {0.0, 0.3}) {
    const LinearSystem system = chain_of_springs(antisymmetric);
    const Modes modes = modes_of(system);
    REQUIRE(modes.square_frequency.size() == 2);
    const double p = 23.0 / 36, root = std::sqrt(p * p - 2.0 / 9);
    CHECK(modes.square_frequency[0] == Approx(p - root).epsilon(1e-13));
    CHECK(modes.square_frequency[1] == Approx(p + root).epsilon(1e-13));
    const Eigen::MatrixXd inertia = modes.shape.transpose() * system.mass.asDiagonal() * modes.shape;
    CHECK((inertia - Eigen::Matrix2d::Identity()).norm() < 1e-14);
    for (int k = 0; k < 2; ++k) CHECK(modes.shape(2, k) == Approx(modes.shape(1, k) / 3));
    CHECK((modes.asymmetry > 0) == (antisymmetric > 0));
  }
}
