#include "surface_beds.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/response/rest.hpp>

using namespace scree;
using namespace scree::response;

namespace {

constexpr double floor_stiffness = 1000, weight = 5;

// A sphere of mass 1 on a floor.
Scene on_floor(double overlap, const std::string& law = "linear_spring_dashpot",
               const test::Values& values = {{"normal_stiffness", {floor_stiffness}},
                                             {"normal_damping", {0}}}) {
  Scene scene = test::scene(3, 1e-4, {test::body(0, 1, 1, {{0, 1 - overlap, 0}})}, values, law);
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  test::add_body_force(scene, "gravity", {{"acceleration", {0, -weight, 0}}});
  return scene;
}

}  // namespace

TEST_CASE("the unbalance of a sphere is its net force over that of its contact", "[response]") {
  const Rest rest = rest_of(Simulation(on_floor(0.01)), {.fewest_contacts = 1});
  CHECK(rest.unbalance == Approx(0.5));  // 10 N up and 5 N down
  REQUIRE(rest.equilibrium);
  // The tolerance of the search, 1e-11, times 5 N over the stiffness.
  CHECK(1 - test::position(*rest.equilibrium, 0)[1] ==
        Approx(weight / floor_stiffness).margin(1e-12).epsilon(0));
  // The stiffness of a linear spring is the same everywhere.
  CHECK(rest.stiffness_change < 1e-6);
  CHECK(rest.warning == "");
}

TEST_CASE("a packing at rest has no other equilibrium", "[response]") {
  const Rest rest = rest_of(Simulation(on_floor(weight / floor_stiffness)), {.fewest_contacts = 1});
  CHECK(rest.unbalance < 1e-12);
  CHECK_FALSE(rest.equilibrium);
  CHECK(rest.warning == "");
}

// Of Hertz the force grows with the power 3/2 of the overlap and the stiffness with 1/2: with twice the
// weight on the contact the stiffness is 2^(1/3) of that in equilibrium. Without friction only the normal
// stiffness counts.
TEST_CASE("a packing whose stiffness differs in equilibrium is warned of", "[response]") {
  const double modulus = 1e4, poisson = 0.25, reduced = modulus / (1 - poisson * poisson) / 2;
  const auto overlap_of = [&](double force) { return std::pow(0.75 * force / reduced, 2.0 / 3); };
  const test::Values values = {
      {"youngs_modulus", {modulus}}, {"poissons_ratio", {poisson}}, {"restitution", {1}}, {"friction", {0}}};
  const Rest rest =
      rest_of(Simulation(on_floor(overlap_of(2 * weight), "hertz_mindlin", values)), {.fewest_contacts = 1});
  CHECK(rest.unbalance == Approx(0.5).epsilon(1e-3));
  REQUIRE(rest.equilibrium);
  CHECK(rest.stiffness_change == Approx(std::cbrt(2) - 1).epsilon(0.02));
  CHECK_THAT(rest.warning, Catch::Contains("and its stiffness differs by 0.26 from the equilibrium nearby"));
}

TEST_CASE("the unbalance is not that of fixed bodies, and the equilibrium nearby leaves them where they are",
          "[response]") {
  Scene scene = on_floor(0);
  scene.boundaries.clear();
  scene.bodies.push_back(test::body(1, 1, 1, {{0, -1 + weight / floor_stiffness, 0}}));
  scene.bodies[1].fixed = true;
  CHECK(rest_of(Simulation(scene), {.fewest_contacts = 1}).unbalance < 1e-12);
  scene.bodies[0].position[1] -= weight / floor_stiffness;  // 10 N up and 5 N down
  const Rest rest = rest_of(Simulation(scene), {.fewest_contacts = 1});
  CHECK(rest.unbalance == Approx(0.5));
  REQUIRE(rest.equilibrium);
  CHECK(test::position(*rest.equilibrium, 0)[1] == Approx(1).margin(1e-12).epsilon(0));
  CHECK(test::position(*rest.equilibrium, 1) == scene.bodies[1].position);
  CHECK(rest.equilibrium->particles().is_fixed(1));
}

// Each bead bears 10 N; the lever is the distance of a bead from the centre.
TEST_CASE("walls whose forces and torques are not in balance are not at rest", "[response][surfaces]") {
  const AssemblyOptions options = {.fewest_contacts = 1};
  CHECK(rest_of(Simulation(test::disc_on_beads(30, 0)), options).unbalance < 1e-12);
  const Rest pressed = rest_of(Simulation(test::disc_on_beads(20, 0)), options);
  CHECK(pressed.unbalance == Approx(1));
  CHECK_THAT(pressed.warning,
             Catch::Contains("no equilibrium nearby was searched for, since torques turn disc"));
  CHECK(rest_of(Simulation(test::disc_on_beads(30, 0.5)), options).unbalance ==
        Approx(0.05 / std::hypot(0.7, 0.29)));
  Scene held = test::disc_on_beads(20, 0);
  held.boundaries[0].parameters.set("spin_control", std::vector<double>{0});
  const Rest found = rest_of(Simulation(held), options);
  REQUIRE(found.equilibrium);
  CHECK(found.equilibrium->contact_list().overlap[0] == Approx(0.02 / 3));
}

// Springs of the beads bear it: three of 600 N/m at 0.7 m, stretched by a turn of 1e-3.
TEST_CASE("a torque that springs bear is in balance", "[response][surfaces]") {
  constexpr double turned = 1e-3, torque = 3 * 600 * 0.7 * 0.7 * turned;
  Scene scene = test::disc_on_beads(30, -torque);
  Parameters& disc = scene.boundaries[0].parameters;
  const Parameters under_torque = disc;
  disc.set("control", std::vector<double>{0});
  disc.set("spin_control", std::vector<double>{2});
  disc.set("spin", std::vector<double>{0, -turned / scene.step});
  Simulation simulation(scene);
  simulation.step();
  simulation.reconfigure_boundary(scene.boundaries[0].name, under_torque);
  simulation.apply_reconfiguration();
  // Of second order in the turn.
  CHECK(rest_of(simulation, {.fewest_contacts = 1}).unbalance < 1e-6);
}
