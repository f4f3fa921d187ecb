#include "packings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include <scree/response/found_modes.hpp>

using namespace scree;
using namespace scree::response;

namespace {

// Spheres near the places of a cubic lattice above a plane, with tangential springs, and with another plane
// above them, without mass and under stress.
LinearSystem pressed_lattice(int side, bool pressed, double wobble = 1e-3,
                             double tangential_stiffness = 700) {
  std::vector<Body> bodies;
  for (int n = 0; n < side * side * side; ++n)
    bodies.push_back(test::body(n, 1, 1 + 0.2 * std::cos(1.1 * n),
                                {{1.99 * (n % side), 1.99 * (n / side % side),
                                  0.995 + 1.99 * (n / side / side) + wobble * std::sin(1.7 * n)}}));
  Scene scene = test::scene(3, 1e-4, std::move(bodies),
                            {{"normal_stiffness", {1000}},
                             {"normal_damping", {0.6}},
                             {"tangential_stiffness", {tangential_stiffness}},
                             {"static_friction", {tangential_stiffness > 0 ? 50.0 : 0}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}}, "floor");
  if (pressed)
    test::add_boundary(scene, "plane",
                       {{"point", {0, 0, 1.99 * side}},
                        {"normal", {0, 0, -1}},
                        {"direction", {0, 0, -1}},
                        {"control", {6}},  // massless
                        {"stress", {0, 5}},
                        {"area", {4.0 * side * side}},
                        {"speed_limit", {1}}},
                       "lid");
  return assemble(Simulation(scene), {.fewest_contacts = 1});
}

std::vector<double> vibrating(const Modes& modes, double rounding) {
  std::vector<double> all;
  for (const double square : modes.square_frequency)
    if (square > rounding) all.push_back(square);
  return all;
}

}  // namespace

TEST_CASE("the lowest modes are those of a dense solver", "[response]") {
  for (const bool pressed : {false, true})
    for (const double wobble : {0.0, 1e-3}) {
      CAPTURE(pressed, wobble);
      const LinearSystem system = pressed_lattice(3, pressed, wobble);
      CHECK((system.mass.array() == 0).count() == (pressed ? 1 : 0));
      const Modes dense = modes_of(system);
      const UndampedSystem undamped(system);
      CHECK(undamped.modes() == std::size_t(dense.square_frequency.size()));
      const std::vector<double> exact = vibrating(dense, undamped.rounding());
      for (const std::size_t count : {std::size_t(5), std::size_t(40), std::size_t(1000)}) {
        CAPTURE(count);
        const FoundModes found = find_modes(undamped, {.count = count});
        CHECK(found.complete);
        CHECK(found.unstable == 0);
        CHECK(exact.size() + found.floppy == undamped.modes());
        const std::size_t vibrating = std::size_t(found.square_frequency.size()) - found.first_vibrating;
        REQUIRE(vibrating == std::min(count, exact.size()));
        for (std::size_t m = 0; m < vibrating; ++m) {
          const Eigen::Index k = Eigen::Index(found.first_vibrating + m);
          // Round-off of the largest eigenvalue.
          CHECK(std::abs(found.square_frequency[k] - exact[m]) < 1e-13 * undamped.largest());
          // Its share in the smallest, and the asymmetry by loaded tangential springs, of which there are
          // none.
          CHECK(found.residual[k] < 1e-8);
        }
        const Eigen::MatrixXd overlaps = found.shape.transpose() * system.mass.asDiagonal() * found.shape;
        CHECK((overlaps - Eigen::MatrixXd::Identity(overlaps.rows(), overlaps.cols())).cwiseAbs().maxCoeff() <
              1e-10);
      }
    }
}

TEST_CASE("the modes nearest to a frequency are those of a dense solver", "[response]") {
  const LinearSystem system = pressed_lattice(3, true);
  const UndampedSystem undamped(system);
  const double near = 0.3 * std::sqrt(undamped.largest());
  // Of more modes, those nearest in ω² are others than those nearest in ω.
  for (const std::size_t count : {std::size_t(12), std::size_t(40)}) {
    CAPTURE(count);
    std::vector<double> exact = vibrating(modes_of(system), undamped.rounding());
    std::sort(exact.begin(), exact.end(), [&](double a, double b) {
      return std::abs(std::sqrt(a) - near) < std::abs(std::sqrt(b) - near);
    });
    const FoundModes found = find_modes(undamped, {.count = count, .near_hz = near / (2 * std::numbers::pi)});
    CHECK(found.complete);
    REQUIRE(std::size_t(found.square_frequency.size()) == found.first_vibrating + count);
    exact.resize(count);
    std::sort(exact.begin(), exact.end());
    for (std::size_t m = 0; m < exact.size(); ++m)
      CHECK(std::abs(found.square_frequency[Eigen::Index(found.first_vibrating + m)] - exact[m]) <
            1e-13 * undamped.largest());
  }
}

TEST_CASE("modes below a frequency are counted as a dense solver counts them", "[response]") {
  for (const bool pressed : {false, true}) {
    const LinearSystem system = pressed_lattice(4, pressed);
    const UndampedSystem undamped(system);
    const Eigen::VectorXd squares = modes_of(system).square_frequency;
    for (int k = -3; k < 60; ++k) {
      const double square = 0.013 * k * std::abs(k) * 1e-2 * undamped.largest() + 1e-6;
      CAPTURE(pressed, k);
      CHECK(undamped.count_below(square).modes == std::size_t((squares.array() < square).count()));
    }
  }
}

// Without tangential springs, spheres on top of one another turn over, and roll on the floor.
TEST_CASE("unstable and floppy modes are found and counted", "[response]") {
  const LinearSystem system = pressed_lattice(3, false, 1e-3, 0);
  const Modes dense = modes_of(system);
  const UndampedSystem undamped(system);
  const Eigen::ArrayXd squares = dense.square_frequency.array();
  const FoundModes found = find_modes(undamped, {.count = 4});
  CHECK(found.unstable == std::size_t((squares < -undamped.rounding()).count()));
  CHECK(found.floppy == std::size_t((squares.abs() <= undamped.rounding()).count()));
  CHECK(found.unstable > 0);
  CHECK(found.floppy > 0);
  CHECK(found.first_floppy == found.unstable);
  CHECK(found.first_vibrating == found.unstable + found.floppy);
  REQUIRE(found.square_frequency.size() == Eigen::Index(found.first_vibrating + 4));
  for (Eigen::Index m = 0; m < found.square_frequency.size(); ++m)
    CHECK(std::abs(found.square_frequency[m] - squares[m]) < 1e-13 * undamped.largest());
}

// A column of zeros beside a force on the first body by the motion of the second. Bodies that turn freely
// between two loaded contacts have such a K.
TEST_CASE("a mode is floppy where it is with all of K, also if its symmetric part is below 0", "[response]") {
  Eigen::Matrix4d stiffness;
  stiffness << 0, 3, 0, 0,  //
      0, 1000, 20, 0,       //
      0, 20, 400, 10,       //
      0, 0, 10, 90;
  for (const double last : {90.0, -5.0}) {
    CAPTURE(last);
    stiffness(3, 3) = last;
    const Eigen::SparseMatrix<double> k = stiffness.sparseView(), none(4, 4), walls(4, 0);
    const LinearSystem system = {.freedom = DegreesOfFreedom(2, 0, {true, true}, {false, false}),
                                 .stiffness = k,
                                 .damping = none,
                                 .mass = Eigen::Vector4d(1, 2, 1, 3),
                                 .wall_stiffness = walls,
                                 .wall_damping = walls,
                                 .wall_mass = walls,
                                 .rattlers = {}};
    const UndampedSystem undamped(system);
    CHECK(undamped.count_below(-undamped.rounding()).modes == (last < 0 ? 2 : 1));
    const FoundModes found = find_modes(undamped, {.count = 3});
    CHECK(found.unstable == (last < 0 ? 1 : 0));
    CHECK(found.floppy == 1);
    CHECK(found.complete);
    const Eigen::Index floppy = Eigen::Index(found.first_floppy);
    CHECK(found.residual[floppy] < 1);
    CHECK(std::abs(found.shape(0, floppy)) == Approx(1));
    CHECK(found.shape.col(floppy).tail(3).norm() < 1e-10);
    if (last < 0) {
      const Eigen::Matrix4d weighted = system.mass.cwiseInverse().asDiagonal() * stiffness;
      CHECK(found.square_frequency[0] == Approx(weighted.eigenvalues().real().minCoeff()).epsilon(1e-10));
    }
  }
}

// A wall without mass or stiffness of its own follows the bodies as far down as one looks, so that its mode
// has no lower bound.
TEST_CASE("the search for unstable modes ends where no ω² can be", "[response]") {
  Eigen::Matrix4d stiffness;
  stiffness << 1000, 0, 0, 30,  //
      0, 700, 0, 20,            //
      0, 0, 400, 10,            //
      30, 20, 10, 0;
  const Eigen::SparseMatrix<double> k = stiffness.sparseView(), none(4, 4), walls(4, 0);
  const LinearSystem system = {.freedom = DegreesOfFreedom(2, 0, {true, true}, {false, false}),
                               .stiffness = k,
                               .damping = none,
                               .mass = Eigen::Vector4d(1, 2, 1, 0),
                               .wall_stiffness = walls,
                               .wall_damping = walls,
                               .wall_mass = walls,
                               .rattlers = {}};
  const UndampedSystem undamped(system);
  REQUIRE(undamped.count_below(-1e6 * undamped.largest()).modes == 1);
  int looks = 0;
  constexpr int many = 100;
  find_modes(undamped,
             {.count = 2,
              .proceed = [&] { return looks < many; },
              .on_progress = [&](double, const std::string& what) { looks += what == "unstable modes"; }});
  // From 1e-11 of the largest ω² to it, by factors of 10; round-off may add one.
  CHECK(looks >= 1);
  CHECK(looks <= 12);
}

// ω_m = 2 √(k/m) sin((2m − 1) π/(2 (2N + 1))) along a row of beads between a wall and nothing, which turns
// over sideways.
TEST_CASE("a long chain has the lowest frequencies of a discrete chain", "[response]") {
  constexpr int beads = 400;
  const double k = 1000, mass = 0.3, overlap = 1e-12;
  std::vector<Body> bodies;
  for (int n = 0; n < beads; ++n)
    bodies.push_back(test::body(n, 1, mass, {{1 - overlap + (2 - overlap) * n, 0, 0}}, {}, {}, 2));
  Scene scene = test::scene(2, 1e-4, std::move(bodies), {{"normal_stiffness", {k}}, {"normal_damping", {0}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {1, 0, 0}}}, "wall");
  const LinearSystem system = assemble(Simulation(scene), {.fewest_contacts = 1});
  const FoundModes found = find_modes(UndampedSystem(system), {.count = 15});
  CHECK(found.floppy + found.unstable == beads);
  REQUIRE(found.square_frequency.size() - Eigen::Index(found.first_vibrating) == 15);
  for (int m = 1; m <= 15; ++m) {
    const double exact =
        2 * std::sqrt(k / mass) * std::sin((2 * m - 1) * std::numbers::pi / (2 * (2 * beads + 1)));
    const double square = found.square_frequency[Eigen::Index(found.first_vibrating) + m - 1];
    // Round-off of the largest ω² in the smallest, half of it in ω: 1e-16 (ω_N/ω_1)²/2 = 1e-11.
    CHECK(std::abs(std::sqrt(square) / exact - 1) < 1e-10);
  }
}
