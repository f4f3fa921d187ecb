#include "equilibrium/equilibrium.hpp"

#include "scenes.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/plugin/program.hpp>

using namespace scree;
using namespace scree::response;

namespace {

constexpr double column_stiffness = 1000, column_gravity = 5;  // (N/m), (m/s²)

// Spheres of radius 1 and mass 1 in a column on a floor, all of whose springs bear 2 N.
Scene sphere_column() {
  const double overlap = 2 / column_stiffness;
  Scene scene = test::scene(
      3, 1e-4, {test::body(0, 1, 1, {{0, 1 - overlap, 0}}), test::body(1, 1, 1, {{0, 3 - 2 * overlap, 0}})},
      {{"normal_stiffness", {column_stiffness}}, {"normal_damping", {0}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  test::add_body_force(scene, "gravity", {{"acceleration", {0, -column_gravity, 0}}});
  return scene;
}

constexpr double tolerance = 1e-11;

}  // namespace

// The overlaps bear the weight above them. The tolerance times 10 N over the stiffness.
TEST_CASE("the balance of a column on a floor bears its weight", "[response]") {
  const Simulation simulation(sphere_column());
  Equilibrium equilibrium(simulation, tolerance);
  const StaticConfiguration from(simulation);
  const Balance balance = equilibrium.find(from, 0, {}, [] { return true; });
  REQUIRE(balance.found);
  const double lower = balance.at.position[0][1], upper = balance.at.position[1][1];
  CHECK(1 - lower == Approx(2 * column_gravity / column_stiffness).margin(1e-12).epsilon(0));
  CHECK(2 - (upper - lower) == Approx(column_gravity / column_stiffness).margin(1e-12).epsilon(0));
  CHECK(balance.loads.force[2][1] == Approx(-2 * column_gravity).epsilon(1e-10));  // on the floor
  CHECK(balance.motion[equilibrium.freedom().translation(0, 1)] ==
        Approx(lower - from.position[0][1]).margin(1e-14));
  CHECK(equilibrium.iterations() > 1);
}

TEST_CASE("a search for balance that is ended finds none", "[response]") {
  const Simulation simulation(sphere_column());
  Equilibrium equilibrium(simulation, tolerance);
  CHECK_FALSE(equilibrium.find(StaticConfiguration(simulation), 0, {}, [] { return false; }).found);
}

TEST_CASE("a body that touches nothing does not take part in a motion", "[response]") {
  Scene scene = sphere_column();
  scene.bodies.push_back(test::body(2, 1, 1, {{9, 9, 0}}));
  const Simulation simulation(scene);
  Equilibrium equilibrium(simulation, tolerance);
  const StaticConfiguration from(simulation);
  equilibrium.find(from, 0, {}, [] { return true; });
  const DegreesOfFreedom& freedom = equilibrium.freedom();
  const Eigen::VectorXd motion = equilibrium.without_free_bodies(Eigen::VectorXd::Ones(freedom.size()));
  CHECK(motion[freedom.translation(0, 1)] == 1);
  for (int k = 0; k < 3; ++k) CHECK(motion[freedom.translation(2, k)] == 0);
}

// A sphere in place of the floor, and one beside it that it overlaps.
TEST_CASE("a column on a fixed sphere is in balance as on a floor, and the fixed one bears its weight",
          "[response]") {
  Scene scene = sphere_column();
  scene.boundaries.clear();
  for (const double x : {0.0, -1.5}) {
    scene.bodies.push_back(test::body(int(scene.bodies.size()), 1, 1, {{x, -1, 0}}));
    scene.bodies.back().fixed = true;
  }
  const Simulation simulation(scene);
  Equilibrium equilibrium(simulation, tolerance);
  const StaticConfiguration from(simulation);
  const Balance balance = equilibrium.find(from, 0, {}, [] { return true; });
  REQUIRE(balance.found);
  CHECK(equilibrium.freedom().size() == 2 * 3);
  const double lower = balance.at.position[0][1], upper = balance.at.position[1][1];
  CHECK(1 - lower == Approx(2 * column_gravity / column_stiffness).margin(1e-12).epsilon(0));
  CHECK(2 - (upper - lower) == Approx(column_gravity / column_stiffness).margin(1e-12).epsilon(0));
  CHECK(balance.at.position[2] == from.position[2]);
  CHECK(balance.loads.force[2][1] == Approx(-2 * column_gravity).epsilon(1e-10));
  CHECK(balance.loads.force[3] == Vec3{});
  CHECK(equilibrium.contacts().touching().size() == 2);
}

// N = (m g + F)/cos α with cos α = y/d, d = 2 − N/k: the support bears what acts along x.
TEST_CASE("a sphere that is held along x, and loaded by a group, is in balance aside of a fixed one",
          "[response]") {
  constexpr double aside = 0.6, load = 0.3;
  Scene scene = sphere_column();
  scene.boundaries.clear();
  scene.bodies = {test::body(0, 1, 1, {}),
                  test::body(1, 1, 1, {{aside, std::sqrt(4 - aside * aside) - 1e-3, 0}})};
  scene.bodies[0].fixed = true;
  scene.bodies[1].held = 1;
  scene.groups.emplace_back().bodies = {1};
  scene.groups[0].load[1] = {Program::constant, -load};
  const Simulation simulation(scene);
  Equilibrium equilibrium(simulation, tolerance);
  const Balance balance = equilibrium.find(StaticConfiguration(simulation), 0, {}, [] { return true; });
  REQUIRE(balance.found);
  CHECK(equilibrium.freedom().size() == 2);
  CHECK(balance.at.position[1][0] == aside);
  const double y = balance.at.position[1][1], d = std::hypot(aside, y);
  CHECK(column_stiffness * (2 - d) * y / d == Approx(column_gravity + load).epsilon(1e-9));
}
