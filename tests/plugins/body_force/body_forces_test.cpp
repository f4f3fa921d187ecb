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
