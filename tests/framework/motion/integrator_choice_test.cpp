#include "scenes.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

// The integrators that a scene may choose, each against the closed form of an oscillation and against what
// its traits state.

using scree::Body;
using scree::Integration;
using scree::Scene;
using scree::Simulation;
using scree::Vec3;
using scree::test::Values;

namespace {

constexpr double oscillator_mass = 1, oscillator_stiffness = 1000, oscillator_gravity = 10,
                 oscillator_radius = 1, oscillator_amplitude = 0.002;

// A body on a plane under its weight, displaced from rest: x = x_eq + A e^(−ηt)(cos ω₁t + η/ω₁ sin ω₁t).
Scene oscillator(Integration integration, double step, double damping) {
  const double rest = oscillator_radius - oscillator_mass * oscillator_gravity / oscillator_stiffness;
  Scene s = scree::test::scene(
      3, step,
      {scree::test::body(0, oscillator_radius, oscillator_mass, {{0, 0, rest + oscillator_amplitude}})},
      {{"normal_stiffness", {oscillator_stiffness}}, {"normal_damping", {damping}}});
  s.integration = integration;
  scree::test::add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  scree::test::add_body_force(s, "gravity", {{"acceleration", {0, 0, -oscillator_gravity}}});
  return s;
}

double displacement(const Simulation& s) {
  return scree::test::position(s, 0)[2] -
         (oscillator_radius - oscillator_mass * oscillator_gravity / oscillator_stiffness);
}

double error_at(Integration integration, int steps, double damping) {
  constexpr double time = 0.128;
  Simulation s(oscillator(integration, time / steps, damping));
  scree::test::run(s, std::uint64_t(steps));
  const double eta = damping / (2 * oscillator_mass),
               omega = std::sqrt(oscillator_stiffness / oscillator_mass - eta * eta);
  return std::abs(displacement(s) - oscillator_amplitude * std::exp(-eta * time) *
                                        (std::cos(omega * time) + eta / omega * std::sin(omega * time)));
}

// Observed order between two steps, ω h = 0.06 and 0.03: the next term of the error is smaller by that.
double order_of_oscillation(Integration integration, double damping) {
  return std::log2(error_at(integration, 64, damping) / error_at(integration, 128, damping));
}

}  // namespace

TEST_CASE("each integrator has its stated order, with and without a dashpot") {
  // The next term of the error is smaller than the leading one by a few times ω h ~ 0.06.
  CHECK(order_of_oscillation(Integration::velocity_verlet, 0) == Approx(2).margin(0.25));
  CHECK(order_of_oscillation(Integration::velocity_verlet, 20) == Approx(2).margin(0.25));
  CHECK(order_of_oscillation(Integration::position_verlet, 0) == Approx(2).margin(0.25));
  CHECK(order_of_oscillation(Integration::position_verlet, 20) == Approx(2).margin(0.25));
  CHECK(order_of_oscillation(Integration::fourth_order, 0) == Approx(4).margin(0.25));
  CHECK(order_of_oscillation(Integration::fourth_order, 20) == Approx(2).margin(0.25));
  // Gear's series starts with its higher terms at 0, an error of the first step that a dashpot amplifies
  // at once.
  CHECK(order_of_oscillation(Integration::predictor_corrector, 0) >= 2.75);
  CHECK(order_of_oscillation(Integration::predictor_corrector, 20) >= 1.75);
}

TEST_CASE("the fourth order pays for its five evaluations in elastic motion") {
  CHECK(error_at(Integration::fourth_order, 64, 0) < error_at(Integration::velocity_verlet, 5 * 64, 0) / 10);
}

TEST_CASE("each integrator is stable up to its stated multiple of velocity Verlet's longest step") {
  // The amplitude after enough steps to detect a growth of 2 % per step.
  for (const scree::IntegrationTraits& traits : scree::integrations())
    for (const double damping_ratio : {0.02, 0.1, 0.3, 1.0}) {
      const double omega = std::sqrt(oscillator_stiffness / oscillator_mass),
                   damping = 2 * damping_ratio * omega * oscillator_mass;
      const double limit =
          2 /
          (std::sqrt(std::pow(damping / oscillator_mass, 2) + omega * omega) + damping / oscillator_mass) *
          traits.stable_step;
      Simulation s(oscillator(traits.integration, 0.97 * limit, damping));
      scree::test::run(s, 500);
      INFO(traits.name << ", damping ratio " << damping_ratio);
      CHECK(std::abs(displacement(s)) <= oscillator_amplitude);
    }
}

TEST_CASE("velocity Verlet is unstable beyond the longest step of the step guard") {
  for (const double damping_ratio : {0.1, 1.0}) {
    const double omega = std::sqrt(oscillator_stiffness / oscillator_mass), g = 2 * damping_ratio * omega;
    const double limit = 2 / (std::sqrt(g * g + omega * omega) + g);
    Simulation s(oscillator(Integration::velocity_verlet, 1.03 * limit, g * oscillator_mass));
    double farthest = 0;
    for (int n = 0; n < 100; ++n) {
      s.step();
      farthest = std::max(farthest, std::abs(displacement(s)));
    }
    CHECK(farthest > 1.5 * oscillator_amplitude);
  }
}

TEST_CASE("free flight is exact and the energy balance of an elastic bounce closes with every integrator") {
  for (const scree::IntegrationTraits& traits : scree::integrations()) {
    INFO(traits.name);
    Scene scene = scree::test::scene(
        3, 1e-3, {scree::test::body(0, 0.5, 2, {{0, 0, 1}}, {{0.25, 0, -1}}, {{0, 0.5, 0}})},
        {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}});
    scene.spin = true;
    scene.integration = traits.integration;
    scree::test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
    Simulation s(scene);
    scree::test::run(s, 250);
    // 250 steps of at most 5 substeps, each with two roundings of numbers up to 1.
    CHECK(scree::test::position(s, 0)[2] == Approx(0.75).margin(250 * 10 * 2.2e-16));
    scree::test::run(s, 750);
    CHECK(scree::test::velocity(s, 0)[2] > 0);
    CHECK(s.particles().body(0).spin == Vec3{{0, 0.5, 0}});
    // The contact lasts π/(ω h) = 44 steps; the energy error of the step is (ω h)² relative.
    CHECK(s.energy_residual() < std::pow(std::sqrt(1e4 / 2) * 1e-3, 2));
  }
}

TEST_CASE("walls that a stage starts or stops have the right position with every integrator") {
  // Only a plane whose program is changed twice: 0.05 m in 0.1 s, then held.
  for (const scree::IntegrationTraits& traits : scree::integrations()) {
    INFO(traits.name);
    Scene scene = scree::test::scene(3, 1e-3, {scree::test::body(1, 0.1, 1, {{0, 0, 5}})},
                                     {{"normal_stiffness", {1e3}}, {"normal_damping", {0}}});
    scene.integration = traits.integration;
    const auto plane = [](double rate) {
      return Values{{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"displacement", {3, 0, rate, 1}}};
    };
    scree::test::add_boundary(scene, "plane", plane(0.5));
    Simulation s(scene);
    scree::test::run(s, 100);
    s.reconfigure_boundary("plane", scree::test::parameters("plane", SCREE_BOUNDARY, plane(0)));
    s.apply_reconfiguration();
    scree::test::run(s, 50);
    // Roundings of 750 substeps.
    CHECK(s.planes()[0].point[2] == Approx(0.05).margin(750 * 2.2e-16));
  }
}

TEST_CASE("the energy balance closes at the top of a flight and across periodic faces") {
  Scene scene = scree::test::scene(3, 1e-3, {scree::test::body(1, 0.1, 1, {{0, 0, 0}}, {{0, 0, 10}})},
                                   {{"normal_stiffness", {1e3}}, {"normal_damping", {0}}});
  scree::test::add_body_force(scene, "gravity", {{"acceleration", {0, 0, -10}}});
  scree::test::add_boundary(scene, "periodic", {{"axes", {2}}, {"lower", {0, 0, -1}}, {"upper", {0, 0, 1}}});
  Simulation s(scene);
  double worst = 0;
  for (int n = 0; n < 1500; ++n) {
    s.step();
    worst = std::max(worst, s.energy_residual());
  }
  REQUIRE(s.particles().image[2][0] != 0);
  // Velocity Verlet conserves the energy of a projectile up to a few roundings per step.
  CHECK(worst < 1500 * 10 * 2.2e-16);
}
