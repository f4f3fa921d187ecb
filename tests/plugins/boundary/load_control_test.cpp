#include "wall_support.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/energy.hpp>

// Walls that try displacements, control "servo" and "massless" of `plane` and `box`.

using namespace scree;
using namespace scree::test;

namespace {

constexpr double bead_radius = 0.01, lid_stiffness = 1e4, lid_force = 3, lid_speed_limit = 0.05,
                 lid_step = 1e-5, lid_tries = 400;
const Values linear = {{"normal_stiffness", {lid_stiffness}}, {"normal_damping", {0}}};
const Values hertz = {
    {"youngs_modulus", {1e7}}, {"poissons_ratio", {0.25}}, {"restitution", {1}}, {"friction", {0}}};

// A heavy bead at rest on a fixed floor, and a lid at a height that is pressed on it. The bead does not move.
Scene bead_under_lid(int control, const Values& law, const std::string& plugin, double height_of_wall) {
  Scene sc = scene(3, lid_step, {body(1, bead_radius, 1e30, {})}, law, plugin);
  add_boundary(sc, "plane",
               {{"point", {0, 0, height_of_wall}},
                {"normal", {0, 0, -1}},
                {"control", {double(control)}},
                {"force", {0, lid_force}},
                {"mass", {0.01}},
                {"viscosity", {20}},
                {"speed_limit", {lid_speed_limit}},
                {"tries", {lid_tries}}},
               "lid");
  return sc;
}

double load(const Simulation& s) { return s.loads()[0].force[2]; }

// Beads in a row along x that touch, between a driven wall and one under a force.
Scene row(int control, double damping, double h, const std::vector<double>& drive = {1, 0, 2e-5, 40, 0}) {
  const double overlap = lid_force / lid_stiffness;
  std::vector<Body> bodies;
  for (int n = 0; n < 8; ++n)
    bodies.push_back(
        body(n, bead_radius, 0.02, {{bead_radius - overlap + n * (2 * bead_radius - overlap), 0, 0}}));
  Scene sc =
      scene(3, h, std::move(bodies), {{"normal_stiffness", {lid_stiffness}}, {"normal_damping", {damping}}});
  add_boundary(sc, "plane",
               {{"point", {0, 0, 0}},
                {"normal", {1, 0, 0}},
                {"control", {plane_displacement}},
                {"displacement", drive}},
               "wall");
  add_boundary(sc, "plane",
               {{"point", {8 * (2 * bead_radius - overlap) - overlap, 0, 0}},
                {"normal", {-1, 0, 0}},
                {"control", {double(control)}},
                {"force", {0, lid_force}},
                {"speed_limit", {1}},
                {"tries", {1e4}}},
               "lid");
  return sc;
}

// Position of the lid and residual of the energy balance after a time.
struct End {
  double position, residual, worst_load;
};
End end_of(int control, double damping, double h) {
  Simulation s(row(control, damping, h));
  End end = {0, 0, 0};
  while (s.time() < 0.02 - 0.5 * h) {
    s.step();
    end.worst_load = std::max(end.worst_load, std::abs(s.loads()[1].force[0] - lid_force));
  }
  end.position = s.planes()[1].point[0];
  end.residual = s.energy().residual;
  return end;
}
double order(double coarse, double middle, double fine) {
  return std::log2(std::abs((coarse - middle) / (middle - fine)));
}

}  // namespace

TEST_CASE("a wall that keeps its load comes with the speed limit and stops at the overlap of that load",
          "[plane]") {
  const int control = GENERATE(int(plane_force), int(plane_servo), int(plane_massless));
  const bool is_hertz = GENERATE(false, true);
  CAPTURE(control, is_hertz);
  const double gap = 1e-4,
               contact = 4.0 / 3 * 1e7 / (1 - 0.25 * 0.25) / 2 * std::sqrt(bead_radius) * (is_hertz ? 1 : 0);
  Simulation s(bead_under_lid(control, is_hertz ? hertz : linear,
                              is_hertz ? "hertz_mindlin" : "linear_spring_dashpot", bead_radius + gap));
  // A wall is the same material: E* = Y/(2(1 − ν²)).
  const double overlap = is_hertz ? std::pow(lid_force / contact, 2.0 / 3) : lid_force / lid_stiffness;
  const bool tries_displacements = control != plane_force;
  if (tries_displacements) {
    run(s, 100);
    CHECK(bead_radius + gap - height_of_wall(s) == Approx(lid_speed_limit * s.time()).epsilon(1e-12));
    CHECK(load(s) == 0);
  }
  run(s, 40000);
  const double stiffness = is_hertz ? 1.5 * lid_force / overlap : lid_stiffness;
  // Half a displacement of the grid; 1e-9 of the force; the wall of mass and viscosity has come to rest.
  const double resolution = control == plane_servo      ? 0.51 * lid_speed_limit * lid_step / lid_tries
                            : control == plane_massless ? 1.1e-9 * lid_force / stiffness
                                                        : 1e-12;
  CHECK(std::abs(bead_radius - height_of_wall(s) - overlap) <= resolution);
  CHECK(std::abs(load(s) - lid_force) <= 1.01 * stiffness * resolution);
}

TEST_CASE("a wall that keeps its load leaves a body that presses more, and stays where nothing presses",
          "[plane]") {
  for (const int control : {int(plane_servo), int(plane_massless)}) {
    Simulation s(bead_under_lid(control, linear, "linear_spring_dashpot", bead_radius - 5e-4));
    run(s, 100);
    CHECK(height_of_wall(s) == Approx(bead_radius - 5e-4 + lid_speed_limit * s.time()).epsilon(1e-12));
    run(s, 1000);
    CHECK(load(s) == Approx(lid_force).epsilon(1e-3));
    Scene sc = bead_under_lid(control, linear, "linear_spring_dashpot", 2 * bead_radius);
    sc.boundaries.clear();
    add_boundary(sc, "plane",
                 {{"point", {0, 0, 2 * bead_radius}},
                  {"normal", {0, 0, -1}},
                  {"control", {double(control)}},
                  {"stress", {0, 0}},
                  {"area", {1}},
                  {"speed_limit", {lid_speed_limit}}});
    Simulation unpressed(sc);
    run(unpressed, 100);
    CHECK(height_of_wall(unpressed) == 2 * bead_radius);
  }
}

// The displaced load is the evaluation that follows, so that the load itself has no error but that of the
// search. The speed of the wall at the end of a step is displacement / step: first order with dashpots,
// second without.
TEST_CASE("a massless wall behind a driven row keeps its force, to first order in its motion", "[plane]") {
  for (const double damping : {0.0, 4.0}) {
    CAPTURE(damping);
    const End coarse = end_of(plane_massless, damping, 4e-5), middle = end_of(plane_massless, damping, 2e-5),
              fine = end_of(plane_massless, damping, 1e-5);
    for (const End& end : {coarse, middle, fine}) CHECK(end.worst_load < 1.1e-9 * lid_force);
    const double expected = damping > 0 ? 1 : 2;
    CHECK(order(coarse.position, middle.position, fine.position) == Approx(expected).margin(0.3));
    CHECK(std::log2(std::abs(middle.residual / fine.residual)) > expected - 0.4);
  }
}

TEST_CASE("a servo wall behind a driven row keeps its force to the resolution of its displacements",
          "[plane]") {
  const double h = 1e-5;
  const End servo = end_of(plane_servo, 4, h), massless = end_of(plane_massless, 4, h);
  // Half a displacement of the grid changes the spring, and the dashpot by its speed.
  CHECK(servo.worst_load <= 0.51 * h / 1e4 * (lid_stiffness + 4 / h));
  // The lid is off by at most that of every bead of the row, and a few times as much in waves.
  CHECK(std::abs(servo.position - massless.position) < 100 * servo.worst_load / lid_stiffness);
}

TEST_CASE("a wall that keeps its load feels bodies that were far away at the last search", "[plane]") {
  const double speed = 1, weak = 0.01, skin = 5 * speed * lid_step;
  double largest = 0;
  for (int n = 0; n < 20; ++n) {
    const double gap = skin + (0.02 + 0.2 * n) * speed * lid_step;
    Scene sc = scene(3, lid_step, {body(1, bead_radius, 0.02, {}, {{0, 0, 0.9 * speed}})}, linear);
    sc.skin = skin;
    add_boundary(sc, "plane",
                 {{"point", {0, 0, bead_radius + gap}},
                  {"normal", {0, 0, -1}},
                  {"control", {plane_massless}},
                  {"force", {0, weak}},
                  {"speed_limit", {speed}}});
    Simulation s(sc);
    for (int k = 0; k < 30; ++k) {
      s.step();
      largest = std::max(largest, load(s));
    }
  }
  CHECK(largest == Approx(weak).epsilon(2e-9));
}

TEST_CASE("a superposed motion of a wall that keeps its load is made up for", "[plane]") {
  for (const int control : {int(plane_servo), int(plane_massless)}) {
    Scene sc =
        bead_under_lid(control, linear, "linear_spring_dashpot", bead_radius - lid_force / lid_stiffness);
    Values shaken = {{"point", {0, 0, bead_radius - lid_force / lid_stiffness}},
                     {"normal", {0, 0, -1}},
                     {"control", {double(control)}},
                     {"force", {0, lid_force}},
                     {"speed_limit", {lid_speed_limit}},
                     {"tries", {lid_tries}},
                     {"superposed", {1, 0, 1e-5, 100, 0}}};
    sc.boundaries.clear();
    add_boundary(sc, "plane", shaken);
    Simulation s(sc);
    run(s, 2000);
    CHECK(std::abs(load(s) - lid_force) <= 0.51 * lid_stiffness * lid_speed_limit * lid_step / lid_tries);
  }
}

TEST_CASE("walls of a box that keep their loads press with the present area", "[box]") {
  for (const int control : {int(box_servo), int(box_massless)}) {
    Scene sc = scene(3, lid_step, {body(1, bead_radius, 0.02, {})},
                     {{"normal_stiffness", {lid_stiffness}}, {"normal_damping", {20}}});
    add_boundary(sc, "box",
                 {{"gap", {1e-5}},
                  {"x", {double(control)}},
                  {"y", {double(control)}},
                  {"z", {double(control)}},
                  {"stress", {0, 2000}},
                  {"stress_y", {0, 5000}},
                  {"speed_limit", {lid_speed_limit}},
                  {"tries", {lid_tries}}});
    Simulation s(sc);
    run(s, 3000);
    const Vec3 length = s.lengths();
    for (int w = 0; w < 6; ++w) {
      const int axis = w / 2;
      const double area = length[(axis + 1) % 3] * length[(axis + 2) % 3], p = axis == 1 ? 5000 : 2000;
      // At rest to the grid; the dashpot feels its speed.
      CHECK(std::abs(s.loads()[std::size_t(w)].force[axis]) ==
            Approx(p * area).margin(0.51 * lid_speed_limit * lid_step / lid_tries *
                                    (lid_stiffness + 20 / lid_step)));
    }
  }
}

TEST_CASE("walls that keep their loads go on from a state, with any number of threads, to the same bits",
          "[box][threads]") {
  const int control = GENERATE(int(box_servo), int(box_massless));
  const auto integration =
      GENERATE(Integration::velocity_verlet, Integration::position_verlet, Integration::fourth_order);
  std::vector<Body> bodies;
  for (int n = 0; n < 300; ++n)
    bodies.push_back(body(n, 0.5 + 0.02 * std::sin(n), 1,
                          {{double(n % 10), double(n / 10 % 10), double(n / 100)}},
                          {{std::sin(3.0 * n), std::cos(5.0 * n), std::sin(7.0 * n)}}));
  Scene sc = scene(3, 1e-3, bodies,
                   {{"normal_stiffness", {1e4}},
                    {"restitution", {0.8}},
                    {"tangential_stiffness", {3e3}},
                    {"static_friction", {0.3}}});
  sc.integration = integration;
  sc.min_bodies_per_thread = 1;
  add_boundary(sc, "box",
               {{"x_low", {box_fixed}},
                {"x_high", {double(control)}},
                {"y", {double(control)}},
                {"z", {box_fixed}},
                {"stress", {0, 500}},
                {"speed_limit", {3}},
                {"superposed_x_high", {1, 0, 0.01, 20, 0}}});
  Simulation one(sc), observed(sc);
  one.run(40, [] { return true; });
  run(observed, 40);
  CHECK(one.state_hash() == observed.state_hash());
  const State stopped = one.state();
  one.run(40, [] { return true; });
  REQUIRE(one.rebuilds() > 1);
  for (const unsigned threads : {1u, 3u}) {
    CAPTURE(threads);
    sc.threads = threads;
    Simulation resumed(sc, stopped), whole(sc);
    run(resumed, 40);
    whole.run(80, [] { return true; });
    CHECK(resumed.state_hash() == one.state_hash());
    CHECK(whole.state_hash() == one.state_hash());
  }
}

TEST_CASE("walls that try displacements are refused by name without what they need", "[box][plane]") {
  const auto plane = [](const Values& v) {
    return [v] {
      Values all = {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}};
      all.insert(all.end(), v.begin(), v.end());
      Scene sc = scene(3, lid_step, {body(1, bead_radius, 1, {{0, 0, 1}})}, linear);
      add_boundary(sc, "plane", all);
      Simulation s(sc);
    };
  };
  CHECK_THROWS_WITH(plane({{"control", {plane_servo}}, {"speed_limit", {1}}})(),
                    Catch::Contains("needs either stress or force; give stress = <Pa>, area = <m^2>"));
  CHECK_THROWS_WITH(plane({{"control", {plane_servo}}, {"speed_limit", {1}}, {"stress", {0, 1}}})(),
                    Catch::Contains("stress without area; give area = <m^2>"));
  CHECK_THROWS_WITH(plane({{"control", {plane_massless}}, {"force", {0, 1}}})(),
                    Catch::Contains("without speed_limit; give speed_limit = <m/s>"));
  Scene sc = scene(3, lid_step, {body(1, bead_radius, 1, {})}, linear);
  add_boundary(sc, "box", {{"x", {box_servo}}, {"stress", {0, 1}}});
  CHECK_THROWS_WITH(Simulation(sc),
                    Catch::Contains("wall x_low has no speed limit; give speed_limit = <m/s>"));
}
