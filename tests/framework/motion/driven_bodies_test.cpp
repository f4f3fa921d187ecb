#include "motion/driven.hpp"
#include "scenes.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/plugin/program.hpp>

// References: closed forms, and a Runge-Kutta integration of a body in a cage of springs, with functions of
// time and geometry written here. A bound is the change of an error where steps are halved: 4 for order 2, 16
// for order 4.

using scree::Body;
using scree::BodyGroup;
using scree::Integration;
using scree::Program;
using scree::Scene;
using scree::Simulation;
using scree::Vec3;
using scree::test::bit;
using scree::test::group_of;
using scree::test::integrators;
using scree::test::Values;
using std::numbers::pi;

namespace {

namespace freedom = scree::freedom;

// A free body of radius 1 m between two others along each axis, of which the first along x is driven. All
// contacts last.
struct Cage {
  static constexpr double stiffness = 50, mass = 1.3, inner = 1.8, frequency = 0.3, amplitude = 0.06;
  static constexpr double pushed = 0.7, end = 1;  // force along y (N), time (s)

  int dimension;
  double damping;
  freedom::Mask held = 0;  // of the inner body
  Vec3 drift = {};         // its velocity at the start (m/s)

  // Velocity of the driven body along y (m/s), whose displacement along x is amplitude sin(2π f t) too.
  static double lift(double t) {
    return amplitude * 2 * pi * frequency * std::cos(2 * pi * frequency * t + 0.4);
  }
  static double push(double t) { return pushed * std::sin(2 * pi * 0.5 * t + 0.2); }

  Scene scene(Integration integration, double step) const {
    std::vector<Body> bodies = {scree::test::body(1, 1, mass, {}, drift, {}, dimension)};
    for (int k = 0; k < dimension; ++k)
      for (const double side : {-inner, inner}) {
        Vec3 x = {};
        x[k] = side;
        bodies.push_back(scree::test::body(std::int64_t(bodies.size()) + 1, 1, 1, x, {}, {}, dimension));
        bodies.back().fixed = true;
      }
    bodies[0].held = held;
    Scene s = scree::test::scene(dimension, step, bodies,
                                 {{"normal_stiffness", {stiffness}}, {"normal_damping", {damping}}});
    s.integration = integration;
    BodyGroup driven = group_of("driven", {1}), loaded = group_of("loaded", {0});
    driven.displacement[0] = {Program::sine, 5, amplitude, frequency, 0};
    driven.velocity[1] = {Program::sine, 0, amplitude * 2 * pi * frequency, frequency, 0.4 + pi / 2};
    loaded.load[1] = {Program::sine, 0, pushed, 0.5, 0.2};
    s.groups = {driven, loaded};
    return s;
  }
};

// The inner body, the work of its load and of what drives the other, by Runge-Kutta of order 4.
struct Reference {
  Cage cage;
  // x, v of the inner body, y of the driven one, work (J).
  using Numbers = std::array<double, 8>;

  Numbers rate(double t, const Numbers& n) const {
    const double x_driven = -Cage::inner + Cage::amplitude * std::sin(2 * pi * Cage::frequency * t),
                 u_driven =
                     Cage::amplitude * 2 * pi * Cage::frequency * std::cos(2 * pi * Cage::frequency * t);
    double force[3] = {0, Cage::push(t), 0};
    Numbers d = {};
    d[7] = Cage::push(t) * n[4];
    for (int k = 0; k < cage.dimension; ++k)
      for (const int side : {-1, 1}) {
        const bool is_driven = k == 0 && side < 0;
        double at[3] = {}, u[3] = {}, apart[3], distance = 0, closing = 0;
        at[k] = side * Cage::inner;
        if (is_driven) at[0] = x_driven, at[1] = n[6], u[0] = u_driven, u[1] = Cage::lift(t);
        for (int c = 0; c < 3; ++c) apart[c] = n[std::size_t(c)] - at[c], distance += apart[c] * apart[c];
        distance = std::sqrt(distance);
        for (int c = 0; c < 3; ++c) closing -= (n[std::size_t(3 + c)] - u[c]) * apart[c] / distance;
        const double size = Cage::stiffness * (2 - distance) + cage.damping * closing;
        for (int c = 0; c < 3; ++c) {
          force[c] += size * apart[c] / distance;
          if (is_driven) d[7] += size * apart[c] / distance * u[c];  // against the force on the driven body
        }
      }
    for (std::size_t c = 0; c < 3; ++c) {
      d[c] = n[3 + c];
      const bool free = int(c) < cage.dimension && !freedom::is_in(cage.held, int(c));
      d[3 + c] = free ? force[c] / Cage::mass : 0;
      // What holds a component bears the force on it.
      if (!free) d[7] -= force[c] * n[3 + c];
    }
    d[6] = Cage::lift(t);
    return d;
  }

  Numbers at_end() const {
    constexpr int steps = 2000;
    const double h = Cage::end / steps;
    Numbers n = {0, 0, 0, cage.drift[0], cage.drift[1], cage.drift[2], 0, 0};
    const auto moved = [](const Numbers& from, double by, const Numbers& along) {
      Numbers to = from;
      for (std::size_t k = 0; k < to.size(); ++k) to[k] += by * along[k];
      return to;
    };
    for (int s = 0; s < steps; ++s) {
      const double t = s * h;
      const Numbers a = rate(t, n), b = rate(t + h / 2, moved(n, h / 2, a)),
                    c = rate(t + h / 2, moved(n, h / 2, b)), d = rate(t + h, moved(n, h, c));
      for (std::size_t k = 0; k < n.size(); ++k) n[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    // Driven bodies have 1 kg.
    const auto u = [](double t) {
      return std::pow(Cage::amplitude * 2 * pi * Cage::frequency * std::cos(2 * pi * Cage::frequency * t),
                      2) +
             std::pow(Cage::lift(t), 2);
    };
    n[7] += 0.5 * (u(Cage::end) - u(0));
    return n;
  }
};

struct Errors {
  double position, work, residual;
};

// interrupted: forces are evaluated once more at half of the time, as where a stage begins.
Errors errors_of(const Cage& cage, Integration integration, double step, bool interrupted) {
  Simulation s(cage.scene(integration, step));
  const auto steps = std::uint64_t(std::llround(Cage::end / step));
  s.run(steps / 2, [] { return true; });
  if (interrupted) {
    s.reconfigure_law("linear_spring_dashpot", s.scene().laws[0].parameters);
    s.apply_reconfiguration();
  }
  s.run(steps - steps / 2, [] { return true; });
  const auto expected = Reference{cage}.at_end();
  const Vec3 x = scree::test::position(s, 0), driven = scree::test::position(s, 1);
  // The functions of time themselves are followed to round-off and, of a velocity, by Simpson's rule.
  CHECK(driven[0] ==
        Approx(-Cage::inner + Cage::amplitude * std::sin(2 * pi * Cage::frequency)).epsilon(1e-12));
  CHECK(driven[1] == Approx(expected[6]).margin(1e-9));
  CHECK(scree::test::velocity(s, 1)[1] == Approx(Cage::lift(s.time())).epsilon(1e-12));
  const scree_energy e = s.energy();
  return {norm(x - Vec3{{expected[0], expected[1], expected[2]}}), std::abs(e.work - expected[7]),
          std::abs(e.residual)};
}

void check_order(const Cage& cage, Integration integration, double step, double least,
                 bool interrupted = false) {
  const Errors coarse = errors_of(cage, integration, step, interrupted),
               fine = errors_of(cage, integration, step / 2, interrupted);
  INFO(cage.dimension << "D, integrator " << int(integration) << ", damping " << cage.damping << ", held "
                      << int(cage.held));
  CAPTURE(coarse.position, fine.position, coarse.work, fine.work, coarse.residual, fine.residual);
  CHECK(coarse.position < 1e-3);
  CHECK(fine.position < coarse.position / least);
  // Forces of position_verlet are those half a step before, and so is the work.
  if (integration != Integration::position_verlet) CHECK(fine.work < coarse.work / least);
  CHECK(fine.residual < coarse.residual / least);
}

}  // namespace

TEST_CASE("a body that groups push and load moves as an integration of its equation of motion says",
          "[driven]") {
  const int dimension = GENERATE(2, 3);
  for (const Integration integration : integrators) check_order({dimension, 1.5}, integration, 0.01, 3.2);
}

TEST_CASE("an evaluation of forces between two steps keeps the order of motion, work and balance",
          "[driven]") {
  const int dimension = GENERATE(2, 3);
  check_order({dimension, 1.5}, Integration::position_verlet, 0.01, 3.2, true);
  check_order({dimension, 1.5, bit(1), {{0, 0.05, 0}}}, Integration::position_verlet, 0.01, 3.2, true);
  check_order({dimension, 1.5}, Integration::velocity_verlet, 0.01, 3.2, true);
}

TEST_CASE("between driven bodies without dashpots the fourth order is kept", "[driven]") {
  const int dimension = GENERATE(2, 3);
  check_order({dimension, 0}, Integration::fourth_order, 0.02, 13);
}

TEST_CASE("a body that is held in some components keeps its velocity there and moves freely in the others",
          "[driven]") {
  const int dimension = GENERATE(2, 3);
  for (const Integration integration : integrators)
    for (const int k : {0, 1}) {
      Cage cage{dimension, 1.5, bit(k)};
      cage.drift[k] = 0.05;
      cage.drift[1 - k] = -0.03;
      check_order(cage, integration, 0.01, 3.2);
      Simulation s(cage.scene(integration, 0.01));
      for (int n = 1; n <= 50; ++n) {
        s.step();
        REQUIRE(scree::test::velocity(s, 0)[k] == 0.05);
        REQUIRE(scree::test::position(s, 0)[k] == Approx(0.05 * s.time()).epsilon(1e-13));
      }
    }
}

TEST_CASE("a body that is held horizontally falls on its parabola", "[driven]") {
  const double gravity = 9.81, step = 0.01;
  for (const Integration integration : integrators) {
    Body ball = scree::test::body(1, 0.5, 2, {{0, 0, 50}}, {{0.25, 0, 3}});
    ball.held = bit(0) | bit(1);
    Scene scene = scree::test::scene(3, step, {ball}, {{"normal_stiffness", {1}}, {"normal_damping", {0}}});
    scree::test::add_body_force(scene, "gravity", {{"acceleration", {5, 3, -gravity}}});
    scene.integration = integration;
    Simulation s(scene);
    scree::test::run(s, 100);
    const double t = 100 * step;
    // Round-off of some hundred sums of 50 m.
    CHECK(scree::test::position(s, 0)[2] == Approx(50 + 3 * t - 0.5 * gravity * t * t).epsilon(1e-13));
    CHECK(scree::test::position(s, 0)[0] == Approx(0.25 * t).epsilon(1e-13));
    CHECK(scree::test::position(s, 0)[1] == 0);
    // Gravity moves it along x, too, and what holds it takes this work up.
    CHECK(s.energy().work ==
          Approx(-2 * 5 * 0.25 * t).epsilon(integration == Integration::position_verlet ? 0.01 : 1e-9));
    // position_verlet: with forces of half a step before, its balance is of order 2.
    CHECK(s.energy_residual() < (integration == Integration::position_verlet ? 1e-4 : 1e-12));
  }
}

TEST_CASE("a body held along x rests on a fixed one where the normal force bears its weight", "[driven]") {
  const double stiffness = 1e4, weight = 2 * 9.81, aside = 0.6;
  Body upper = scree::test::body(2, 1, 2, {{aside, 1.905, 0}}, {}, {}, 2);
  Body lower = scree::test::body(1, 1, 2, {}, {}, {}, 2);
  lower.fixed = true;
  upper.held = bit(0);
  Scene scene = scree::test::scene(2, 1e-3, {lower, upper},
                                   {{"normal_stiffness", {stiffness}}, {"normal_damping", {150}}});
  scree::test::add_body_force(scene, "gravity", {{"acceleration", {0, -9.81, 0}}});
  Simulation s(scene);
  scree::test::run(s, 2000);
  // N cos α = m g with cos α = y/d; d = 2 − N/k.
  const double y = scree::test::position(s, 1)[1], d = std::hypot(aside, y);
  CHECK(norm(scree::test::velocity(s, 1)) < 1e-9);
  CHECK(stiffness * (2 - d) * y / d == Approx(weight).epsilon(1e-7));
  // What holds it bears the horizontal part, which is in its force.
  CHECK(s.particles().force()[0][1] == Approx(weight * aside / y).epsilon(1e-7));
  CHECK(scree::test::position(s, 1)[0] == aside);
}

namespace {

// A disc that slides on a plane under its weight, with Coulomb friction.
Scene sliding_disc(Integration integration, freedom::Mask held, const Vec3& velocity, double spin) {
  Body disc = scree::test::body(1, 0.1, 2, {{0, 0.1 - 2 * 9.81 / 1e5, 0}}, velocity, {{0, 0, spin}}, 2);
  disc.held = held;
  Scene scene = scree::test::scene(2, 1e-4, {disc},
                                   {{"normal_stiffness", {1e5}},
                                    {"normal_damping", {0}},
                                    {"tangential_stiffness", {5e4}},
                                    {"tangential_damping", {0}},
                                    {"static_friction", {0.3}}});
  scree::test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  scree::test::add_body_force(scene, "gravity", {{"acceleration", {0, -9.81, 0}}});
  scene.integration = integration;
  return scene;
}

}  // namespace

TEST_CASE("a disc that must not turn slides to rest as a block, and one that is turned drives itself",
          "[driven]") {
  const double braking = 0.3 * 9.81, t = 0.2;
  for (const Integration integration : integrators) {
    Simulation block(sliding_disc(integration, bit(5), {{1, 0, 0}}, 0)),
        roller(sliding_disc(integration, bit(5), {}, -40));
    for (Simulation* s : {&block, &roller}) s->run(2000, [] { return true; });
    // The spring is loaded to the limit in the first 0.1 ms of 200.
    CHECK(scree::test::velocity(block, 0)[0] == Approx(1 - braking * t).epsilon(2e-3));
    CHECK(block.particles().body(0).spin[2] == 0);
    CHECK(scree::test::velocity(roller, 0)[0] == Approx(braking * t).epsilon(2e-3));
    CHECK(roller.particles().body(0).spin[2] == -40);
    // Torque μ m g R at 40 rad/s.
    CHECK(roller.energy().work == Approx(0.3 * 2 * 9.81 * 0.1 * 40 * t).epsilon(2e-3));
    CHECK(roller.energy_residual() < 2e-3);
    CHECK(block.energy_residual() < 2e-3);
  }
}

TEST_CASE("a torque of a group turns a body, and its work is the energy of rotation", "[driven]") {
  const int dimension = GENERATE(2, 3);
  for (const Integration integration : integrators) {
    Scene scene = scree::test::scene(dimension, 1e-3, {scree::test::body(1, 0.1, 2, {}, {}, {}, dimension)},
                                     {{"normal_stiffness", {1}}, {"normal_damping", {0}}});
    scene.integration = integration;
    BodyGroup motor = group_of("motor", {0});
    motor.load[5] = {Program::sine, 0, 0.01, 0.5, 0};
    scene.groups = {motor};
    Simulation s(scene);
    s.run(1000, [] { return true; });
    const Body body = s.particles().body(0);
    const double spin = 0.01 / body.inertia * (1 - std::cos(pi)) / pi;
    // Trapezoidal rule with 1000 steps of half a period; Gear's method begins with no derivative of the
    // torque.
    CHECK(body.spin[2] ==
          Approx(spin).epsilon(integration == Integration::predictor_corrector ? 1e-5 : 2e-6));
    if (integration != Integration::position_verlet)
      CHECK(s.energy().work == Approx(0.5 * body.inertia * spin * spin).epsilon(1e-5));
    CHECK(s.energy_residual() < 1e-5);
  }
}
