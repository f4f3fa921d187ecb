#include "wall_support.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/branching.hpp>
#include <scree/state.hpp>
#include <scree/wall_surfaces.hpp>

// States of scenes with surfaces.

using namespace scree;
using namespace scree::test;

namespace {

const Values law_of_states = {{"normal_stiffness", {1e5}},
                              {"restitution", {0.7}},
                              {"tangential_stiffness", {3e4}},
                              {"static_friction", {0.4}}};

}  // namespace

TEST_CASE("a run with surfaces goes on from its state to the same bits, with each integrator", "[surfaces]") {
  const std::string law = GENERATE("linear_spring_dashpot", "sphere_path_independent");
  CAPTURE(law);
  for (const Integration integration : {Integration::velocity_verlet, Integration::position_verlet,
                                        Integration::fourth_order, Integration::predictor_corrector}) {
    std::vector<Body> bodies;
    for (int i = 0; i < 8; ++i)
      bodies.push_back(
          body(i + 1, 0.05, 0.1, {{0.11 * (i % 4) - 0.16, 0.11 * (i / 4) - 0.05, 0}}, {{0.3, -0.2, 0.1}}));
    Scene sc = scene(3, 1e-5, bodies, law_of_states, law);
    sc.integration = integration;
    add_boundary(sc, "cylinder",
                 {{"point", {0, 0, 0}},
                  {"axis", {0, 0, 1}},
                  {"radius", {0.3}},
                  {"side", {2}},
                  {"spin", {1, 0, 8, 20, 0}},
                  {"velocity", {1, 0, 0.3, 15, 0}}});
    add_boundary(sc, "rectangle",
                 {{"point", {0, 0, -0.1}},
                  {"normal", {0, 0, 1}},
                  {"along", {1, 0, 0}},
                  {"length", {1}},
                  {"width", {1}},
                  {"spin", {2}},
                  {"spin_point", {0.1, 0, 0}}});
    add_body_force(sc, "gravity", {{"acceleration", {0, -9.81, -1}}});
    Simulation whole(sc);
    run(whole, 3000);
    Simulation first(sc);
    run(first, 1300);
    Simulation second(sc, first.state());
    run(second, 1700);
    CHECK(second.state_hash() == whole.state_hash());
    CHECK(whole.state_hash() != first.state_hash());
  }
}

TEST_CASE("a scene with other gravity takes over surfaces and springs on them from a state", "[surfaces]") {
  std::vector<Body> bodies;
  for (int i = 0; i < 8; ++i)
    bodies.push_back(body(i + 1, 0.05, 0.1, {{0.11 * (i % 4) - 0.16, 0.11 * (i / 4) - 0.05, 0}}));
  Scene sc = scene(3, 1e-5, bodies, law_of_states);
  add_boundary(sc, "plane", {{"point", {0, 0, -0.06}}, {"normal", {0, 0, 1}}}, "first");
  add_boundary(sc, "cylinder",
               {{"point", {0, 0, 0}}, {"axis", {0, 0, 1}}, {"radius", {0.3}}, {"side", {2}}, {"spin", {2}}});
  add_body_force(sc, "gravity", {{"acceleration", {0, -9.81, -1}}});
  Simulation first(sc);
  run(first, 40000);
  REQUIRE(std::abs(first.surfaces().loads[0].torque[2]) > 0);
  Scene other = sc;
  for (std::size_t i = 0; i < bodies.size(); ++i) other.bodies[i] = first.particles().body(i);
  other.body_forces.clear();
  // Behind another boundary, so that its walls have other numbers.
  std::swap(other.boundaries[0], other.boundaries[1]);
  add_boundary(other, "disc", {{"point", {0, 0, 0.2}}, {"normal", {0, 0, -1}}, {"radius", {1}}});
  std::rotate(other.boundaries.begin(), other.boundaries.begin() + 2, other.boundaries.end());
  const Simulation branch(other, first.state(), Branching{});
  CHECK(branch.let_go().empty());
  REQUIRE(branch.surfaces().names == std::vector<std::string>{"disc", "cylinder"});
  for (int k = 0; k < 4; ++k)
    CHECK(branch.surfaces().frames[1].orientation[k] == first.surfaces().frames[0].orientation[k]);
  // Dashpots see velocities as they are instead of as predicted, γ h/m = 2e-3 of the change in a step.
  for (int k = 0; k < 3; ++k)
    CHECK(branch.surfaces().loads[1].force[k] == Approx(first.surfaces().loads[0].force[k]).epsilon(2e-3));
}
