#include "packings.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <scree/response/undamped_system.hpp>

using namespace scree;
using namespace scree::response;

namespace {

// With tangential forces, by which K is not quite symmetric.
LinearSystem strained_heap() {
  const Scene scene = test::heap(3,
                                 {{"normal_stiffness", {1000}},
                                  {"normal_damping", {0}},
                                  {"tangential_stiffness", {600}},
                                  {"static_friction", {50}}},
                                 "linear_spring_dashpot", 1);
  return assemble(Simulation(scene, test::strained(scene)), {.fewest_contacts = 1});
}

}  // namespace

// Dense eigenvalues of the symmetric part of M^−½ K M^−½: round-off of 1e-12 of 1e4.
TEST_CASE("modes are counted as by dense eigenvalues, and the bound of their frequencies holds",
          "[response]") {
  const LinearSystem system = strained_heap();
  const UndampedSystem undamped(system);
  const Eigen::MatrixXd root = Eigen::VectorXd(system.mass.cwiseSqrt().cwiseInverse()).asDiagonal();
  const Eigen::MatrixXd stiffness = root * Eigen::MatrixXd(system.stiffness) * root,
                        symmetric = 0.5 * (stiffness + stiffness.transpose());
  CHECK(undamped.asymmetry() == Approx((stiffness - stiffness.transpose()).norm() / stiffness.norm()));
  CHECK(undamped.asymmetry() > 1e-4);
  const Eigen::VectorXd squares = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues();
  CHECK(undamped.modes() == std::size_t(squares.size()));
  CHECK(undamped.largest() >= squares.maxCoeff());
  CHECK(undamped.largest() == Approx(symmetric.cwiseAbs().rowwise().sum().maxCoeff()));
  for (Eigen::Index k = 0; k + 1 < squares.size(); ++k) {
    const double between = 0.5 * (squares[k] + squares[k + 1]);
    if (squares[k + 1] - squares[k] < 1e-6) continue;
    CHECK(undamped.count_below(between).modes == std::size_t(k) + 1);
    CHECK(undamped.count_below(between).certain);
  }
}

// A spring of 8 to the ground and one of −3 to a wall without mass, which has a spring of 5: in line −3 5/(−3
// + 5).
TEST_CASE("walls without mass are no modes, whatever the sign of their stiffness", "[response]") {
  for (const double wall : {5.0, -5.0}) {
    Eigen::SparseMatrix<double> stiffness(2, 2);
    stiffness.coeffRef(0, 0) = 8 - 3;
    stiffness.coeffRef(0, 1) = stiffness.coeffRef(1, 0) = 3;
    stiffness.coeffRef(1, 1) = wall - 3;
    const LinearSystem system{.freedom = DegreesOfFreedom(1, 0, {true}, {false}, {true}),
                              .stiffness = stiffness,
                              .damping = Eigen::SparseMatrix<double>(2, 2),
                              .mass = Eigen::Vector2d(1, 0),
                              .wall_stiffness = Eigen::SparseMatrix<double>(2, 1),
                              .wall_damping = Eigen::SparseMatrix<double>(2, 1),
                              .wall_mass = Eigen::SparseMatrix<double>(2, 1),
                              .rattlers = {}};
    const UndampedSystem undamped(system);
    CHECK(undamped.modes() == 1);
    const double square = 8 - 3 * wall / (wall - 3);
    CHECK(undamped.count_below(square - 0.01).modes == 0);
    CHECK(undamped.count_below(square + 0.01).modes == 1);
  }
}

TEST_CASE("a count at the square frequency of a mode is not certain", "[response]") {
  Scene scene = test::scene(2, 1e-4, {test::body(0, 1, 1, {{0, 0.9, 0}}, {}, {}, 2)},
                            {{"normal_stiffness", {1024}}, {"normal_damping", {0}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  const LinearSystem system = assemble(Simulation(scene), {.fewest_contacts = 1});
  const UndampedSystem undamped(system);
  CHECK_FALSE(undamped.count_below(1024).certain);
  for (const double square : {-1.0, 512.0, 1024 * (1 + 1e-9)}) {
    CHECK(undamped.count_below(square).certain);
    CHECK(undamped.count_below(square).modes == (square < 0 ? 0 : square < 1024 ? 1 : 2));
  }
}
