#include "motion/driven.hpp"
#include "motion/integrator.hpp"
#include "scenes.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/orientations.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Instrumented steps are some fifty times slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t many_steps = 10'000;
#else
constexpr std::uint64_t many_steps = 1'000'000;
#endif

// A single body that turns, without anything that it could touch.
Scene spinning_body(int dimension, const Vec3& spin, double step) {
  Scene s = scene(dimension, step, {body(1, 1e-3, 1e-6, {}, {}, spin, dimension)},
                  {{"normal_stiffness", {1e3}}, {"normal_damping", {0}}});
  s.orientations = true;
  return s;
}

double component(const Simulation& s, int k, std::size_t body = 0) {
  return s.particles().orientations[k][body];
}

// Largest difference from the quaternion of a rotation about a fixed axis.
double deviation(const Simulation& s, const Vec3& spin, double time) {
  const double rate = norm(spin), half = std::remainder(0.5 * rate * time, 2 * std::numbers::pi);
  double worst = std::abs(component(s, 0) - std::cos(half));
  for (int k = 0; k < 3; ++k)
    worst = std::max(worst, std::abs(component(s, 1 + k) - std::sin(half) * spin[k] / rate));
  return worst;
}

Scene torsion_pair(int dimension, double step, double spin) {
  static PluginHost laws({SCREE_TEST_LAWS});
  Parameters law(laws.find("torsion", SCREE_CONTACT_LAW));
  law.set("stiffness", {1e-8});
  const Vec3 axis = {{0, 0, spin}};
  // Twice the density of the first: the bodies have different inertia.
  Scene s;
  s.dimension = dimension;
  s.step = step;
  s.materials = {"grain"};
  s.bodies = {body(1, 1e-3, 1e-6, {{0, 0, 0}}, {}, axis, dimension),
              body(2, 1e-3, 2e-6, {{1.9e-3, 0, 0}}, {}, -0.5 * axis, dimension)};
  s.laws = {{"torsion", law}};
  s.law_of = {0};
  s.limits.overlap_ratio = 1;
  return s;
}

}  // namespace

// The time is 10⁶ steps of 0.3 to 2 µs; 1e-10 is required, the bound is the reference's own: the product
// rate × time of some 10³ to 10⁵ rad is rounded to 1e-16 of itself.
TEST_CASE("a body that spins freely has the exact orientation after 10⁶ steps", "[orientation]") {
  constexpr double step = 3e-6;
  const double time = double(many_steps) * step;
  for (const Integration integration : integrators) {
    for (const double rate : {300.0, 4e5}) {
      INFO("integrator " << int(integration) << ", " << rate << " rad/s");
      Scene flat = spinning_body(2, {{0, 0, rate}}, step);
      flat.integration = integration;
      flat.limits.speed = 1e9;
      Simulation disc(flat);
      disc.run(many_steps, [] { return true; });
      CHECK(std::abs(component(disc, 0) / (rate * time) - 1) < 1e-14);

      const Vec3 spin = {{0.6 * rate, -0.48 * rate, 0.64 * rate}};
      Scene spatial = spinning_body(3, spin, step);
      spatial.integration = integration;
      Simulation sphere(spatial);
      sphere.run(many_steps, [] { return true; });
      CHECK(deviation(sphere, spin, time) < 1e-10);
      double square = -1;
      for (int k = 0; k < 4; ++k) square += component(sphere, k) * component(sphere, k);
      CHECK(std::abs(square) < 4 * 2.2e-16);
    }
  }
}

TEST_CASE("rotations about different axes multiply in the order of time", "[orientation]") {
  Orientations orientations(3, 1);
  const double x[4] = {1.2, 0, 0, 0}, y[4] = {0, 0.7, 0, 0};
  orientations.rotate({x, 4, 1, 0, 3}, 1, 0, 1);
  orientations.rotate({y, 4, 1, 0, 3}, 1, 0, 1);
  // (cos, 0, sin, 0) (cos, sin, 0, 0) of the half angles.
  const double expected[4] = {std::cos(0.35) * std::cos(0.6), std::cos(0.35) * std::sin(0.6),
                              std::sin(0.35) * std::cos(0.6), -std::sin(0.35) * std::sin(0.6)};
  for (int k = 0; k < 4; ++k) CHECK(std::abs(orientations[k][0] - expected[k]) < 3e-16);
}

// About a fixed axis the relative angle φ obeys φ" = −K φ, K = k (1/I_a + 1/I_b); in 3D the spring is that of
// a pendulum, which for φ < 1e-3 differs by φ²/24 < 1e-7.
TEST_CASE("a law that reads orientations swings with its closed form, to second order of the step",
          "[orientation]") {
  for (const int dimension : {2, 3}) {
    const double factor = dimension == 2 ? 0.5 : 0.4, inertia_a = factor * 1e-12, inertia_b = 2 * inertia_a;
    const double omega = std::sqrt(1e-8 * (1 / inertia_a + 1 / inertia_b)), spin = 1e-4 * omega;
    double previous = 0;
    for (const int steps : {200, 400}) {
      const double time = 1.7 / omega;  // not near an extremum
      Simulation s(torsion_pair(dimension, time / steps, spin));
      s.run(std::uint64_t(steps), [] { return true; });
      const double relative_spin = s.particles().spin()[2][0] - s.particles().spin()[2][1];
      const double error = std::abs(relative_spin / (1.5 * spin) - std::cos(omega * time));
      INFO(dimension << "D, " << steps << " steps: error " << error);
      CHECK(error < 0.2 / (steps / 1.7 * steps / 1.7));  // (ωh)²/24 × ωt, with a margin
      if (previous > 0) CHECK(previous / error == Approx(4).epsilon(0.05));
      previous = error;
      CHECK(s.energy_residual() < 1e-4);
    }
  }
}

// θ" = −(k/I) θ: a wall does not turn.
TEST_CASE("a law that reads orientations holds a body at a wall to where it was", "[orientation]") {
  for (const int dimension : {2, 3}) {
    const double omega = std::sqrt(1e-8 / ((dimension == 2 ? 0.5 : 0.4) * 1e-12)), time = 1.7 / omega;
    Scene s = torsion_pair(dimension, time / 400, 1e-4 * omega);
    s.bodies.pop_back();
    add_boundary(s, "plane", {{"point", {-0.9e-3, 0, 0}}, {"normal", {1, 0, 0}}});
    Simulation simulation(s);
    simulation.run(400, [] { return true; });
    const double share = simulation.particles().spin()[2][0] / (1e-4 * omega);
    CHECK(std::abs(share - std::cos(1.7)) < 0.2 * 1.7 * 1.7 / (400 * 400));  // as above
  }
}

TEST_CASE("orientations have the same bits whether the bodies are observed between steps or not",
          "[orientation]") {
  for (const Integration integration : integrators)
    for (const int dimension : {2, 3}) {
      INFO("integrator " << int(integration) << ", " << dimension << "D");
      Scene s = torsion_pair(dimension, 1e-6, 40);
      s.integration = integration;
      Simulation observed(s), unobserved(s);
      run(observed, 100);
      unobserved.run(100, [] { return true; });
      CHECK(observed.state_hash() == unobserved.state_hash());
    }
}

TEST_CASE("orientations are carried and hashed only where they are needed", "[orientation]") {
  Scene with = spinning_body(3, {{0, 0, 100}}, 1e-5), without = with;
  without.orientations = false;
  Simulation carrying(with), plain(without);
  CHECK(carrying.footprint().bytes_per_body == plain.footprint().bytes_per_body + 8 * sizeof(double));
  CHECK_FALSE(plain.particles().orientations);
  run(carrying, 3);
  run(plain, 3);
  CHECK(carrying.state_hash() != plain.state_hash());
  CHECK(Simulation(torsion_pair(2, 1e-6, 1)).particles().orientations);
}

TEST_CASE("the derivatives of the predictor-corrector are part of its hash", "[orientation]") {
  Particles particles(3, {}, {body(1, 1, 1, {}, {{1, 0, 0}})});
  const auto integrator = make_integrator(Integration::predictor_corrector);
  StateHash before, after;
  const BodyRange all = {0, 1};
  integrator->prepare(particles, 1e-3, {&all, 1});
  integrator->add_to_hash(before, {});
  particles.force()[0][0] = 1;
  integrator->begin_step(particles, 1e-3, {0, 1});
  integrator->finish_step(particles, 1e-3, {0, 1});
  integrator->add_to_hash(after, {});
  CHECK(before.value() != StateHash().value());
  CHECK(before.value() != after.value());
}

TEST_CASE("a spin that is not finite, or as large as a number can be, ends the rotation of a body") {
  const double spin = GENERATE(std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::max());
  Orientations orientations(3, 1);
  double numbers[3] = {1, spin, -spin};
  orientations.rotate(Vectors<const double>(numbers, 3, 1, 0, 3), 1, 0, 1);
  double square = 0;
  for (int k = 0; k < 4; ++k) square += orientations[k][0] * orientations[k][0];
  // Doubling a thousand times leaves a unit quaternion, but for round-off.
  CHECK(square == Approx(1).epsilon(1e-9));
}
