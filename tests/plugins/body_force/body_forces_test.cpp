#include "error_line.hpp"
#include "scenes.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const Values elastic = {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}};

}  // namespace

TEST_CASE("gravity: a projectile follows its parabola and conserves energy", "[gravity]") {
  Scene sc = scene(3, 1e-3, {body(1, 0.1, 2, {}, {{3, 0, 4}})}, elastic);
  add_body_force(sc, "gravity", {{"acceleration", {0, 0, -9.81}}});
  Simulation s(sc);
  run(s, 1000);
  // Constant acceleration is exact in velocity Verlet; 1000 roundings.
  CHECK(position(s, 0)[0] == Approx(3).epsilon(1e-13));
  CHECK(position(s, 0)[2] == Approx(4 - 9.81 / 2).epsilon(1e-13));
  CHECK(velocity(s, 0)[2] == Approx(4 - 9.81).epsilon(1e-13));
  CHECK(std::abs(s.energy().residual) < 1e-12 * 25);
}

TEST_CASE("background damping: velocity and spin decay exponentially, to second order in the step",
          "[background_damping]") {
  const double gamma = 0.2, gamma_r = 0.05, m = 1e-3, radius = 0.005;
  const auto error = [&](double step) {
    Scene sc = scene(3, step, {body(1, radius, m, {}, {{1, 2, 3}}, {{10, -20, 30}})}, elastic);
    add_body_force(sc, "background_damping", {{"translational", {gamma}}, {"rotational", {gamma_r}}});
    Simulation s(sc);
    run(s, std::uint64_t(std::llround(0.01 / step)));
    const double inertia = 0.4 * m * radius * radius;
    const Vec3 v = velocity(s, 0), w = s.particles().body(0).spin;
    const double spin_rate = gamma_r * radius * radius / inertia;
    // Energy balance: the dissipated energy is what the bodies lost, to the same order.
    CHECK(std::abs(s.energy().residual) < 1e-2 * s.energy().dissipated_translation);
    return std::max(norm(v - std::exp(-gamma / m * 0.01) * Vec3{{1, 2, 3}}),
                    norm(w - std::exp(-spin_rate * 0.01) * Vec3{{10, -20, 30}}) / 10);
  };
  const double coarse = error(2e-4), fine = error(1e-4);
  // Rates are 200 and 125 per s: (rate Δt)² rate t / 6 = 5e-4 of the remaining velocity at the coarse step,
  // with a factor of 10.
  CHECK(coarse < 5e-3);
  CHECK(std::log2(coarse / fine) == Approx(2).margin(0.2));
}

TEST_CASE("rotational damping does not make a scene carry spin", "[background_damping]") {
  Scene sc = scene(3, 1e-4, {body(1, 0.005, 1e-3, {}, {{1, 0, 0}})}, elastic);
  add_body_force(sc, "background_damping", {{"translational", {0.1}}, {"rotational", {0.1}}});
  Simulation s(sc);
  run(s, 10);
  CHECK_FALSE(s.particles().has_spin());
  CHECK(velocity(s, 0)[0] < 1);
}

TEST_CASE("gravity: components that are functions of time accelerate every body alike, and do work on it",
          "[gravity]") {
  constexpr double pi = 3.14159265358979323846, amplitude = 3, hz = 2, omega = 2 * pi * hz;
  const auto errors = [&](double step) {
    Scene sc = scene(3, step, {body(1, 0.1, 2, {{5, 0, 0}}, {{1, 0, 0}})}, elastic);
    add_body_force(sc, "gravity",
                   {{"acceleration", {0, 0, -9.81}},
                    {"acceleration_x", {1, 0, amplitude, hz, 0}},
                    {"acceleration_z", {1, -4, 1, hz, 0.5 * pi}}});
    Simulation s(sc);
    run(s, std::uint64_t(std::llround(0.7 / step)));
    const double t = 0.7;
    // x" = a sin ωt; z" = −4 + cos ωt in place of −9.81.
    const double x = 5 + (1 + amplitude / omega) * t - amplitude / (omega * omega) * std::sin(omega * t);
    const double z = -2 * t * t + (1 - std::cos(omega * t)) / (omega * omega);
    return std::array<double, 3>{std::abs(position(s, 0)[0] - x), std::abs(position(s, 0)[2] - z),
                                 std::abs(s.energy().residual)};
  };
  const auto coarse = errors(2e-3), fine = errors(1e-3);
  // Velocity Verlet: a (ω Δt)² t/12 / ω of position, 2e-5 m; the work m g' x likewise, with 2 kg and 5 m.
  // Factor 10.
  CHECK(coarse[0] < 2e-4);
  CHECK(coarse[1] < 2e-4);
  CHECK(coarse[2] < 1e-1);
  for (std::size_t k = 0; k < 2; ++k) CHECK(std::log2(coarse[k] / fine[k]) == Approx(2).margin(0.2));
  CHECK(std::log2(coarse[2] / fine[2]) > 1.8);
}

TEST_CASE("gravity: in two dimensions there is no acceleration along z", "[gravity]") {
  Scene sc = scene(2, 1e-4, {body(1, 0.1, 2, {}, {}, {}, 2)}, elastic);
  add_body_force(sc, "gravity", {{"acceleration", {0, 0, 0}}, {"acceleration_z", {0, -9.81}}});
  CHECK_THAT(error_line([&] { Simulation s(sc); }), Catch::Contains("has no acceleration_z; remove it"));
}

TEST_CASE("gravity: the balance closes to second order where g has corners and jumps within steps",
          "[gravity]") {
  // Corners at 1/3 and 2/3 of 0.1 s; within 1 ns, inside of a step and at its end, from 9 to -20 m/s².
  const double jump = GENERATE(0.04231, 0.05);
  const Integration integration = GENERATE(Integration::velocity_verlet, Integration::position_verlet);
  CAPTURE(jump, int(integration));
  const auto residual = [&](double step) {
    Scene sc = scene(3, step, {body(1, 0.1, 2, {{5, 0, 0}}, {{1, 0, 0}})}, elastic);
    sc.integration = integration;
    add_body_force(sc, "gravity",
                   {{"acceleration", {0, 0, 0}},
                    {"acceleration_x", {4, 0, 3, 0.1 / 3, 3, jump, 9, jump + 1e-9, -20, 0.2 / 3, 5, 1, 5}}});
    Simulation s(sc);
    run(s, std::uint64_t(std::llround(0.1 / step)));
    CHECK(s.energy().work == Approx(-2 * (5 - 3) * 5).epsilon(0.2));  // it moves by less than 0.2 m
    return std::abs(s.energy().residual);
  };
  // m h²/8 of the change of g² and m h²/4 times g and the jump: with a factor of 5, m h² × 29 m/s² × 20 m/s².
  const double coarse = residual(1e-3), fine = residual(1e-4);
  CHECK(coarse < 2e-6 * 29 * 20);
  CHECK(fine < 2e-8 * 29 * 20);
}

TEST_CASE("background damping: drags that are functions of time", "[background_damping]") {
  Scene sc = scene(3, 1e-4, {body(1, 0.1, 2, {}, {{1, 0, 0}}, {{0, 0, 4}})}, elastic);
  add_body_force(
      sc, "background_damping",
      {{"translational", {3, 0, 8, 1}}, {"rotational", {2, 0, 8, 1}}});  // a ramp of 8 kg/s in 1 s, a cycle
  Simulation s(sc);
  run(s, 10000);
  // exp(−∫γ dt/m), ∫γ dt = 4 kg for both; I = 2mR²/5. Order 2: (γΔt/m)² of 1e-7, with a factor of 10.
  CHECK(velocity(s, 0)[0] == Approx(std::exp(-4.0 / 2)).epsilon(1e-6));
  CHECK(s.particles().has_spin());
  CHECK(s.particles().body(0).spin[2] == Approx(4 * std::exp(-4.0 / (0.4 * 2))).epsilon(1e-5));
}
