#include "scenes.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/particles.hpp>

// Fixed bodies: forces do not move them, and their contacts are those with an infinite mass.

using scree::Body;
using scree::Integration;
using scree::Scene;
using scree::Simulation;
using scree::Vec3;
using scree::test::Values;
using std::numbers::pi;

namespace {

constexpr double bead_mass = 2, bead_stiffness = 1e4, bead_radius = 1;

Body fixed(Body body) {
  body.fixed = true;
  return body;
}

Body bead(int id, const Vec3& position, const Vec3& velocity = {}, const Vec3& spin = {}, int dimension = 3) {
  return scree::test::body(id, bead_radius, bead_mass, position, velocity, spin, dimension);
}

}  // namespace

// The bodies move towards each other by 3 m/s, and touch after a third of a step. The contact time is π
// √(m/k) but for the dashpot: a step of a 500th has an error of some 1e-5; a reduced mass of m/2 would change
// the contact time by 0.7.
TEST_CASE(
    "a bead rebounds from a fixed bead with the restitution and in the contact time of the mass of one bead") {
  const auto integration = GENERATE(Integration::velocity_verlet, Integration::position_verlet,
                                    Integration::fourth_order, Integration::predictor_corrector);
  const auto dimension = GENERATE(2, 3);
  const double restitution = 0.6, speed = 3,
               damping_ratio = -std::log(restitution) / std::hypot(pi, std::log(restitution)),
               frequency = std::sqrt(bead_stiffness / bead_mass * (1 - damping_ratio * damping_ratio)),
               step = pi / frequency / 500;
  Scene scene = scree::test::scene(
      dimension, step,
      {fixed(bead(0, {}, {}, {}, dimension)),
       bead(1, {{0, 2 * bead_radius + speed * step / 3, 0}}, {{0, -speed, 0}}, {}, dimension)},
      {{"normal_stiffness", {bead_stiffness}}, {"restitution", {restitution}}, {"tension", {0}}});
  scene.integration = integration;
  Simulation s(scene);
  double deepest = 0;
  int touching = 0;
  for (int n = 0; n < 600; ++n) {
    s.step();
    touching += s.contact_list().size() > 0;
    deepest = std::max(deepest, s.max_overlap_ratio());
  }
  CHECK(scree::test::velocity(s, 1)[1] == Approx(restitution * speed).epsilon(1e-3));
  CHECK(touching == Approx(500).margin(2));
  // δ = v/ω exp(−ζ ω₀ t) sin ω t is largest where tan ω t = ω/(ζ ω₀).
  const double decay = damping_ratio * std::sqrt(bead_stiffness / bead_mass),
               at = std::atan2(frequency, decay) / frequency;
  CHECK(deepest * bead_radius ==
        Approx(speed / frequency * std::exp(-decay * at) * std::sin(frequency * at)).epsilon(1e-3));
  CHECK(scree::test::position(s, 0) == Vec3{});
  CHECK(scree::test::velocity(s, 0) == Vec3{});
  CHECK(s.energy_residual() < 1e-3);
  CHECK(s.momentum_residual() < 1e-14);
}

// An oblique impact with friction, against a partner whose mass of 1e30 kg moves by less than round-off.
TEST_CASE("a fixed body acts as one with so large a mass that nothing moves it") {
  const auto integration = GENERATE(Integration::velocity_verlet, Integration::position_verlet,
                                    Integration::fourth_order, Integration::predictor_corrector);
  const auto dimension = GENERATE(2, 3);
  const auto after = [&](Body partner) {
    const double along = dimension == 3 ? 0.5 : 0;
    Scene scene = scree::test::scene(
        dimension, 1e-4,
        {bead(1, {{0.8, 1.85, 0.1 * along}}, {{1, -3, along}}, {{along, -along, 4}}, dimension), partner},
        {{"normal_stiffness", {bead_stiffness}},
         {"restitution", {0.8}},
         {"tangential_stiffness", {3e3}},
         {"tangential_damping", {1}},
         {"static_friction", {0.3}},
         {"rolling_friction", {0.1}}});
    scene.integration = integration;
    Simulation s(scene);
    scree::test::run(s, 800);
    CHECK(s.contact_list().size() == 0);
    return s.particles().body(0);
  };
  const Body by_mass = after(scree::test::body(2, bead_radius, 1e30, {}, {}, {}, dimension)),
             by_fixing = after(fixed(bead(2, {}, {}, {}, dimension)));
  for (int k = 0; k < 3; ++k) {
    // Round-off of 800 steps.
    CHECK(by_fixing.position[k] == Approx(by_mass.position[k]).epsilon(1e-12).margin(1e-12));
    CHECK(by_fixing.velocity[k] == Approx(by_mass.velocity[k]).epsilon(1e-11).margin(1e-11));
    CHECK(by_fixing.spin[k] == Approx(by_mass.spin[k]).epsilon(1e-11).margin(1e-11));
  }
  CHECK(std::abs(by_fixing.spin[2] - 4) > 0.5);
}

// x_i = x_i0 + A sin(i π/(n + 1)) sin ω t, ω = 2 √(k/m) sin(π/(2(n + 1))), while no contact opens. After a
// period of 400 steps the phase is wrong by 2π (ωh)²/24 = 6e-5, which the position next to its zero shows in
// full.
TEST_CASE("a compressed row between two fixed beads vibrates as a chain that is clamped at both ends") {
  const auto integration = GENERATE(Integration::velocity_verlet, Integration::position_verlet,
                                    Integration::fourth_order, Integration::predictor_corrector);
  const int n = 5;
  const double overlap = 1e-3, amplitude = 1e-4, spacing = 2 * bead_radius - overlap;
  const double omega = 2 * std::sqrt(bead_stiffness / bead_mass) * std::sin(pi / (2 * (n + 1)));
  std::vector<Body> bodies;
  for (int i = 0; i <= n + 1; ++i) {
    const double speed = amplitude * omega * std::sin(i * pi / (n + 1));
    const bool end = i == 0 || i == n + 1;
    bodies.push_back(bead(i, {{i * spacing, 0, 0}}, {{end ? 0 : speed, 0, 0}}));
    bodies.back().fixed = end;
  }
  Scene scene = scree::test::scene(3, 2 * pi / omega / 400, bodies,
                                   {{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {0}}});
  scene.integration = integration;
  Simulation s(scene);
  // position_verlet evaluates energies at mid-step.
  const double start = s.energy().kinetic_translation;
  scree::test::run(s, 1000);
  for (int i = 0; i <= n + 1; ++i) {
    INFO(i);
    const double moved = scree::test::position(s, std::size_t(i))[0] - i * spacing;
    CHECK(
        moved ==
        Approx(amplitude * std::sin(i * pi / (n + 1)) * std::sin(omega * s.time())).margin(4e-4 * amplitude));
  }
  CHECK(s.energy().kinetic_translation == Approx(start).epsilon(1e-3));
  CHECK(s.energy_residual() < 1e-4);
  CHECK(scree::test::position(s, 0) == Vec3{});
}

TEST_CASE("fixed bodies exert no force on each other, however much they overlap") {
  Scene scene = scree::test::scene(
      3, 1e-4, {fixed(bead(0, {})), fixed(bead(1, {{0.1, 0, 0}})), bead(2, {{0, 1.99, 0}})},
      {{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {0}}});
  Simulation s(scene);
  REQUIRE(s.contact_list().size() == 2);
  for (std::size_t c = 0; c < 2; ++c) CHECK(s.contact_list().b[c] == 2);
  CHECK(s.max_overlap_ratio() < 0.02);
  // Of a bead at (0, 1.99) with both: the overlap with the second is 2 − √(1.99² + 0.1²).
  const double other = 2 - std::hypot(1.99, 0.1);
  CHECK(s.energy().elastic_normal ==
        Approx(0.5 * bead_stiffness * (0.01 * 0.01 + other * other)).epsilon(1e-9));
  scene.bodies[1].fixed = false;
  CHECK_THROWS_WITH(Simulation(scene), Catch::Contains("they overlap at the start"));
}

TEST_CASE("a fixed body bears its weight and load, and holds them against gravity and drag") {
  Scene scene = scree::test::scene(
      3, 1e-3, {fixed(bead(0, {})), bead(1, {{0, 2 * bead_radius - bead_mass * 10 / bead_stiffness, 0}})},
      {{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {0}}});
  scree::test::add_body_force(scene, "gravity", {{"acceleration", {0, -10, 0}}});
  scree::test::add_body_force(scene, "background_damping", {{"translational", {1}}, {"rotational", {1}}});
  Simulation s(scene);
  scree::test::run(s, 100);
  CHECK(scree::test::position(s, 0) == Vec3{});
  CHECK(s.particles().force()[1][0] == Approx(-2 * bead_mass * 10));
  CHECK(s.particles().force()[1][1] == Approx(0).margin(1e-9));
  // m g y of both, of which only the upper one could fall.
  CHECK(s.energy().potential == Approx(bead_mass * 10 * scree::test::position(s, 1)[1]));
  CHECK(s.energy_residual() < 1e-12);
}

// A wall of the mass of one bead, at first at rest, overshoots by e F/k. Step errors of velocity Verlet.
TEST_CASE("a wall is pressed onto a fixed bead with the dashpot of the mass of the bead") {
  const double restitution = 0.5, force = 10;
  Scene scene = scree::test::scene(3, 1e-4, {fixed(bead(0, {}))},
                                   {{"normal_stiffness", {bead_stiffness}}, {"restitution", {restitution}}});
  scree::test::add_boundary(scene, "plane",
                            {{"point", {0, bead_radius, 0}},
                             {"normal", {0, -1, 0}},
                             {"direction", {0, -1, 0}},
                             {"control", {4}},
                             {"force", {0, force}},
                             {"mass", {bead_mass}},
                             {"viscosity", {0}}});
  Simulation s(scene);
  double lowest = bead_radius;
  for (int n = 0; n < 600; ++n) {
    s.step();
    lowest = std::min(lowest, s.planes()[0].point[1]);
  }
  CHECK(bead_radius - lowest == Approx((1 + restitution) * force / bead_stiffness).epsilon(1e-4));
  CHECK(scree::test::position(s, 0) == Vec3{});
  CHECK(s.energy_residual() < 1e-3);
}

TEST_CASE("a fixed body with a velocity keeps it, and pushes what it meets at the work of its force") {
  const double damping = 100;
  Scene scene =
      scree::test::scene(3, 1e-4, {fixed(bead(0, {}, {{0, 0.5, 0}}, {{0, 0, 2}})), bead(1, {{0, 2, 0}})},
                         {{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {damping}}});
  Simulation s(scene);
  scree::test::run(s, 2000);
  CHECK(scree::test::position(s, 0)[1] == Approx(0.5 * s.time()).epsilon(1e-12));
  CHECK(s.particles().body(0).spin == Vec3{{0, 0, 2}});
  REQUIRE(s.particles().force()[1][1] == 0);
  // It has left with the momentum m v that the fixed body has given it at 0.5 m/s.
  const double speed = scree::test::velocity(s, 1)[1];
  CHECK(speed > 0.5);
  CHECK(s.energy().work == Approx(0.5 * s.particles().mass[1] * speed).epsilon(1e-6));
  CHECK(s.energy_residual() < 1e-3);
}

TEST_CASE("only bodies that are fixed change the state hash, the footprint and the size of a scene") {
  const Values law = {{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {0}}};
  const Scene free =
      scree::test::scene(3, 1e-4, {bead(0, {}), bead(1, {{3, 0, 0}}), bead(2, {{6, 0, 0}})}, law);
  Scene with_fixed = free;
  with_fixed.bodies[1].fixed = true;
  Scene other = free;
  other.bodies[2].fixed = true;
  const Simulation a(free), b(with_fixed), c(other);
  CHECK(a.particles().fixed.empty());
  CHECK(a.footprint().fixed_bodies == 0);
  CHECK(a.footprint().degrees_of_freedom == 9);
  CHECK(b.footprint().fixed_bodies == 1);
  CHECK(b.footprint().degrees_of_freedom == 6);
  CHECK(b.footprint().bytes_per_body == a.footprint().bytes_per_body + 1);
  CHECK(b.particles().body(1).fixed);
  CHECK_FALSE(b.particles().body(2).fixed);
  CHECK(a.state_hash() != b.state_hash());
  CHECK(b.state_hash() != c.state_hash());
}
