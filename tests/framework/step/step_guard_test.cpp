#include "scenes.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/energy.hpp>
#include <scree/step_guard.hpp>

// Limits against closed forms; that longer steps are unstable and shorter ones stable is shown by
// integrator_choice_test.cpp for one contact and by the last case for a lattice.

using scree::Body;
using scree::Scene;
using scree::shortest_limit;
using scree::Simulation;
using scree::test::Values;
using std::numbers::pi;

namespace {

constexpr double grain_mass = 2, grain_stiffness = 1e4, grain_radius = 1;

Values damped_law(double damping = 0) {
  return {{"normal_stiffness", {grain_stiffness}}, {"normal_damping", {damping}}};
}

Body grain(int id, double x, double y = 0) {
  return scree::test::body(id, grain_radius, grain_mass, {{x, y, 0}});
}

// Layers of a triangular lattice of discs, periodic and compressed, with speeds of the size of rounding
// errors.
Scene triangular_lattice(double share_of_limit) {
  std::vector<Body> bodies;
  const int per_row = 6, rows = 6;
  const double spacing = 1.99 * grain_radius, height = spacing * std::sqrt(3.0) / 2;
  for (int i = 0; i < per_row * rows; ++i) {
    const int row = i / per_row;
    bodies.push_back(scree::test::body(i + 1, grain_radius, grain_mass,
                                       {{spacing * (i % per_row + 0.5 * (row % 2)), height * row, 0}},
                                       {{1e-9 * ((i * 7) % 5 - 2), 1e-9 * ((i * 3) % 7 - 3), 0}}, {}, 2));
  }
  // Strong dashpots: damping ratio 3.
  Scene s =
      scree::test::scene(2, 1e-6, bodies, damped_law(2 * 3 * std::sqrt(grain_stiffness * grain_mass / 2)));
  scree::test::add_boundary(
      s, "periodic", {{"axes", {3}}, {"lower", {0, 0, 0}}, {"upper", {spacing * per_row, height * rows, 0}}});
  s.step = share_of_limit * shortest_limit(Simulation(s)).longest_step;
  return s;
}

}  // namespace

TEST_CASE("the limit of an isolated pair is its stability limit, with and without a dashpot") {
  for (const double damping : {0.0, 50.0, 1000.0}) {
    const Simulation s(scree::test::scene(3, 1e-6, {grain(1, 0), grain(2, 3)}, damped_law(damping)));
    const double g = damping / (grain_mass / 2), square = grain_stiffness / (grain_mass / 2);
    CHECK(shortest_limit(s).longest_step == Approx(2 / (std::sqrt(g * g + square) + g)));
  }
}

TEST_CASE("for bodies with several contacts, four times the stiffness and damping count") {
  const double damping = 300;
  const Simulation s(
      scree::test::scene(3, 1e-6, {grain(1, 0), grain(2, 3), grain(3, 6)}, damped_law(damping)));
  const double g = 4 * damping / (grain_mass / 2), square = 4 * grain_stiffness / (grain_mass / 2);
  CHECK(shortest_limit(s).longest_step == Approx(2 / (std::sqrt(g * g + square) + g)));
}

TEST_CASE("the limit of one body on a wall follows from its own mass") {
  Scene scene = scree::test::scene(3, 1e-6, {grain(1, 0, 3)}, damped_law());
  scree::test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  CHECK(shortest_limit(Simulation(scene)).longest_step ==
        Approx(2 / std::sqrt(grain_stiffness / grain_mass)));
}

TEST_CASE("the limit of one body that may touch fixed ones is that of a body on a wall") {
  Scene scene = scree::test::scene(3, 1e-6, {grain(1, 0), grain(2, 3)}, damped_law());
  scene.bodies[1].fixed = true;
  // A fixed body is not light, whatever its mass.
  scene.bodies[1].mass = 1e-6 * grain_mass;
  CHECK(shortest_limit(Simulation(scene)).longest_step ==
        Approx(2 / std::sqrt(grain_stiffness / grain_mass)));
  CHECK(scree::shortest_contact_time(scene, 1) == Approx(pi / std::sqrt(grain_stiffness / grain_mass)));
  scene.bodies[0].fixed = true;
  CHECK(std::isinf(scree::shortest_contact_time(scene, 1)));
}

TEST_CASE("the limit of a light wall on fixed bodies follows from its mass") {
  Scene s = scree::test::scene(3, 1e-9, {grain(1, 0)}, damped_law());
  s.bodies[0].fixed = true;
  const double light = 1e-6;
  scree::test::add_boundary(s, "box", {{"stress", {0, 1}}, {"mass", {light}}});
  CHECK(shortest_limit(Simulation(s)).longest_step == Approx(2 / std::sqrt(grain_stiffness / light)));
}

TEST_CASE("fixed bodies of small mass are not damped") {
  Scene drag = scree::test::scene(3, 1e-6, {grain(1, 0), grain(2, 3)}, damped_law());
  scree::test::add_body_force(drag, "background_damping", {{"translational", {1e6}}});
  drag.bodies[1].mass = 1e-3 * grain_mass;
  drag.bodies[1].fixed = true;
  CHECK(shortest_limit(Simulation(drag)).longest_step == Approx(grain_mass / 1e6));
}

TEST_CASE("the speed of a cloud counts relative to fixed bodies") {
  Scene s = scree::test::scene(3, 1e-9, {grain(1, 0), grain(2, 3), grain(3, 9)}, damped_law());
  for (Body& body : s.bodies) body.velocity[0] = 1e5;
  s.bodies[2].velocity = {};
  s.bodies[2].fixed = true;
  CHECK(shortest_limit(Simulation(s)).longest_step == Approx(0.1 * grain_radius / 1e5));
}

TEST_CASE("the limit depends on the stability of the integrator") {
  for (const scree::IntegrationTraits& traits : scree::integrations()) {
    Scene scene = scree::test::scene(3, 1e-6, {grain(1, 0), grain(2, 3)}, damped_law());
    scene.integration = traits.integration;
    CHECK(shortest_limit(Simulation(scene)).longest_step ==
          Approx(traits.stable_step * 2 / std::sqrt(grain_stiffness / (grain_mass / 2))));
  }
}

TEST_CASE("drag, fast bodies, light and viscous walls limit the step and are named") {
  Scene drag = scree::test::scene(3, 1e-6, {grain(1, 0)}, damped_law());
  scree::test::add_body_force(drag, "background_damping", {{"translational", {1e6}}});
  CHECK(shortest_limit(Simulation(drag)).longest_step == Approx(grain_mass / 1e6));
  CHECK_THAT(shortest_limit(Simulation(drag)).cause, Catch::Contains("drag"));

  Scene fast = scree::test::scene(3, 1e-9, {grain(1, 0), grain(2, 3)}, damped_law());
  fast.bodies[0].velocity = {{-1e5, 0, 0}};
  // Relative to the mean velocity of both.
  CHECK(shortest_limit(Simulation(fast)).longest_step == Approx(0.1 * grain_radius / 0.5e5));

  const auto box = [](double wall_mass, double viscosity) {
    Scene s = scree::test::scene(3, 1e-9, {grain(1, 0)}, damped_law());
    scree::test::add_boundary(s, "box",
                              {{"stress", {0, 1}}, {"mass", {wall_mass}}, {"viscosity", {viscosity}}});
    return shortest_limit(Simulation(s));
  };
  const double light = 1e-6;
  CHECK(box(light, 0).longest_step == Approx(2 / std::sqrt(grain_stiffness * (1 / grain_mass + 1 / light))));
  CHECK_THAT(box(light, 0).cause, Catch::Contains("wall 'box."));
  CHECK(box(1, 1e7).longest_step == Approx(1e-7));
  CHECK_THAT(box(1, 1e7).cause, Catch::Contains("viscosity"));
}

// A contact at the distance r from the axis of a spin feels the mass I/r² beside m: 1/m + r²/I is how
// easily it moves the surface.
TEST_CASE("surfaces that forces and torques move limit the step like walls of the mass that contacts feel") {
  const double light = 1e-6, inertia = 1e-8, radius = 0.2, off = 0.3;
  const auto limit = [&](const std::string& plugin, scree::test::Values values) {
    Scene s = scree::test::scene(3, 1e-9, {grain(1, 0)}, damped_law());
    values.insert(values.end(), {{"point", {-9, 0, -9}}, {"radius", {radius}}});
    scree::test::add_boundary(s, plugin, values);
    return shortest_limit(Simulation(s));
  };
  const auto step = [&](double mass) {
    return Approx(2 / std::sqrt(grain_stiffness * (1 / grain_mass + 1 / mass)));
  };
  const scree::test::Values pushed = {{"normal", {0, 0, 1}}, {"force", {0, 1}}, {"mass", {light}}},
                            turned = {{"axis", {0, 0, 1}}, {"torque", {0, 1}}, {"inertia", {inertia}}};
  CHECK(limit("disc", pushed).longest_step == step(light));
  CHECK_THAT(limit("disc", pushed).cause, Catch::Contains("wall 'disc' of 1e-06 kg"));
  CHECK(limit("cylinder", turned).longest_step == step(inertia / (radius * radius)));
  scree::test::Values both = turned, apart = turned;
  both.insert(both.end(), {{"force", {0, 1}}, {"mass", {light}}});
  CHECK(limit("cylinder", both).longest_step == step(1 / (1 / light + radius * radius / inertia)));
  apart.insert(apart.end(), {{"length", {0.1}}, {"spin_point", {off, 0, 0}}});
  const double reach = std::hypot(radius, 0.05) + std::hypot(9 + off, 9);
  CHECK(limit("cylinder", apart).longest_step == step(inertia / (reach * reach)));
  // Viscosity damps a distance at 1e7/s, a turn at 2e7/s.
  const scree::test::Values slow = {
      {"normal", {0, 0, 1}}, {"force", {0, 1}}, {"mass", {1}}, {"viscosity", {1e7}}};
  CHECK(limit("disc", slow).longest_step == Approx(1e-7));
  scree::test::Values slower = slow;
  slower.insert(slower.end(), {{"torque", {0, 1}}, {"inertia", {1}}, {"spin_viscosity", {2e7}}});
  CHECK(limit("disc", slower).longest_step == Approx(5e-8));
  // Heavy ones and prescribed ones do not; fast ones do.
  CHECK(limit("disc", {{"normal", {0, 0, 1}}, {"velocity", {0, 1e5}}}).longest_step ==
        Approx(0.1 * grain_radius / 1e5));
  // The rim of a disc that tumbles; a spin about its own axis leaves it where it is.
  CHECK(limit("disc", {{"normal", {0, 0, 1}}, {"spin", {0, 1e6}}, {"spin_axis", {1, 0, 0}}}).longest_step ==
        Approx(0.1 * grain_radius / (1e6 * radius)));
  CHECK(limit("disc", {{"normal", {0, 0, 1}}, {"spin", {0, 1e6}}}).longest_step > 1e-6);
}

TEST_CASE("the limit of a cloud does not depend on its mean velocity, unless there are walls") {
  const auto limit = [](double boost, bool wall) {
    Scene s = scree::test::scene(3, 1e-9, {grain(1, 0), grain(2, 3)}, damped_law());
    for (Body& body : s.bodies) body.velocity[0] += boost;
    if (wall) scree::test::add_boundary(s, "plane", {{"point", {-1, 0, 0}}, {"normal", {1, 0, 0}}});
    return shortest_limit(Simulation(s)).longest_step;
  };
  CHECK(limit(1e4, false) == Approx(limit(0, false)));
  CHECK(limit(1e5, true) == Approx(0.1 * grain_radius / 1e5));
  Scene flying = scree::test::scene(3, 1e-6, {grain(1, 0), grain(2, 3)}, damped_law());
  for (Body& body : flying.bodies) body.velocity[0] = 1e4;
  Simulation simulation(flying);
  CHECK_NOTHROW(scree::test::run(simulation, 10));
}

TEST_CASE("a strongly damped lattice stays at rest at the longest step, and explodes at three times that") {
  const auto energy_after = [](double share) {
    Simulation s(triangular_lattice(share));
    scree::test::run(s, 400);
    return scree::kinetic_energy(s.energy());
  };
  // It starts with speeds of 1e-9 m/s and a pressure, from an overlap of 1 % of a radius, that cannot relax.
  CHECK(energy_after(1) < 1e-15);
  CHECK_THROWS_WITH(energy_after(3), Catch::Contains("overlap is "));
}

TEST_CASE("the limit of a moving wall without neighbours follows from the law of its own material") {
  Scene s = scree::test::scene(3, 1e-9, {grain(1, 0)}, damped_law());
  s.materials = {"grain", "wall"};
  s.law_of = {0, 1, 1, 0};
  s.laws.push_back({"stiff", s.laws[0].parameters});
  s.laws[1].parameters.set("normal_stiffness", {100 * grain_stiffness});
  const double light = 1e-6;
  scree::test::add_boundary(s, "box", {{"gap", {5}}, {"stress", {0, 1}}, {"mass", {light}}});
  s.boundaries.back().material = 1;
  CHECK(shortest_limit(Simulation(s)).longest_step ==
        Approx(2 / std::sqrt(100 * grain_stiffness * (1 / grain_mass + 1 / light))));
}
