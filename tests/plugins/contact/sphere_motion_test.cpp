#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

// Motions of single spheres with `sphere_path_independent`.

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

constexpr double rolling_radius = 0.01, rolling_mass = 0.01;

Values law(bool hertz, double friction, double restitution) {
  if (hertz)
    return {{"normal", {1}},
            {"youngs_modulus", {1e8}},
            {"poissons_ratio", {0.3}},
            {"restitution", {restitution}},
            {"friction", {friction}}};
  return {{"normal_stiffness", {1e6}},
          {"restitution", {restitution}},
          {"tangential_stiffness", {2.9e5}},
          {"tangential_damping", {restitution < 1 ? 20.0 : 0.0}},
          {"static_friction", {friction}}};
}

Scene scene_of(bool hertz, double friction, double restitution, double step,
               const std::vector<Body>& bodies) {
  return scene(3, step, bodies, law(hertz, friction, restitution), "sphere_path_independent");
}

double kinetic(const scree_energy& e) { return e.kinetic_translation + e.kinetic_rotation; }

// An oblique impact with spins about all axes, until the bodies have parted; from a 10th of a step before
// first touch.
scree_energy impact(bool hertz, bool wall, double step) {
  const double start = 0.1 * step;
  const Vec3 velocity = {{0.8, 0.3, -1}};
  std::vector<Body> bodies = {body(1, rolling_radius, rolling_mass,
                                   Vec3{{0, 0, rolling_radius}} - start * velocity, velocity,
                                   {{60, -40, 90}})};
  if (!wall)
    bodies.push_back(body(2, 0.6 * rolling_radius, 0.4 * rolling_mass, {{0, 0, -0.6 * rolling_radius}}, {},
                          {{-30, 20, 50}}));
  Scene s = scene_of(hertz, 0.4, 0.7, step, bodies);
  if (wall) add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  Simulation simulation(s);
  const double contact_time = 2e-3;  // longer than any of these
  run(simulation, std::uint64_t(contact_time / step));
  REQUIRE(simulation.contact_list().size() == 0);
  return simulation.energy();
}

}  // namespace

TEST_CASE(
    "the energy balance of oblique impacts of spheres closes as the square of the step, and nothing is created",
    "[sphere]") {
  for (const bool hertz : {false, true})
    for (const bool wall : {false, true}) {
      INFO((hertz ? "hertz" : "linear") << (wall ? ", wall" : ", pair"));
      // Contacts of about 3e-4 s and 1e-3 s.
      const double step = hertz ? 1e-5 : 4e-6, ratio = step * pi / (hertz ? 8e-4 : 3e-4),
                   turnover = 0.5 * rolling_mass * 1.73;
      const scree_energy coarse = impact(hertz, wall, step), fine = impact(hertz, wall, step / 8);
      // Trapezoidal sums of powers, as in scenarios/verification: 3 (πh/t_c)² of the turnover.
      CHECK(std::abs(coarse.residual) < 3 * ratio * ratio * turnover);
      CHECK(std::abs(fine.residual) < 3 * ratio * ratio / 64 * turnover);
      CHECK(coarse.created < 1e-12 * turnover);
      CHECK(fine.dissipated_friction > 0.01 * turnover);
      CHECK(fine.dissipated_tangential > 1e-5 * turnover);
      CHECK(fine.dissipated_normal > 0.01 * turnover);
    }
}

TEST_CASE("head-on impacts of spheres have the restitution that is demanded, with and without tension",
          "[sphere]") {
  // Contacts of 3e-4 s (linear) and 8e-4 s at 1 m/s; steps of 1/200. Second order, (πh/t_c)² = 2.5e-4, with a
  // coefficient of 1 or less, of the speed.
  for (const bool hertz : {false, true})
    for (const double friction : {0.0, 0.4})
      for (const double tension : {0.0, 1.0}) {
        INFO((hertz ? "hertz" : "linear") << ", friction " << friction << ", tension " << tension);
        Values values = law(hertz, friction, 0.5);
        values.push_back({"tension", {tension}});
        const double step = (hertz ? 8e-4 : 3e-4) / 200;
        Scene s = scene(
            3, step,
            {body(1, rolling_radius, rolling_mass, {{0, 0, rolling_radius + 0.3 * step}}, {{0, 0, -1}})},
            values, "sphere_path_independent");
        add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
        Simulation simulation(s);
        double speed = -1, largest_speed = -1;
        for (int k = 0; k < 500; ++k) {
          simulation.step();
          speed = velocity(simulation, 0)[2];
          largest_speed = std::max(largest_speed, speed);
        }
        CHECK(speed == Approx(0.5).margin(2.5e-4));
        // Attraction brakes the body at the end.
        CHECK((largest_speed - speed > 1e-3) == (tension == 0));
      }
}

TEST_CASE("a sphere that slides onto a plane rolls from 2v/(7μg) at 5v/7, and goes on rolling", "[sphere]") {
  constexpr double speed = 1, friction = 0.3, gravity = 9.81, step = 2e-5;
  for (const bool hertz : {false, true}) {
    INFO((hertz ? "hertz" : "linear"));
    // E* and G* of the law. Coulomb's limit is that of the spring force, which bears the weight less
    // ½ k_t' ξ² = μ² E*/(24 G*) of itself.
    const double effective_modulus = 1e8 / (2 * (1 - 0.3 * 0.3)), shear_modulus = 1e8 / (4 * 1.7 * 1.3);
    const double share = hertz ? 1 / (1 + friction * friction * effective_modulus / (24 * shear_modulus)) : 1;
    const double braking = share * friction * gravity, time = 2 * speed / (7 * braking);
    const double overlap =
        hertz ? std::pow(0.75 * rolling_mass * gravity / (effective_modulus * std::sqrt(rolling_radius)),
                         2.0 / 3)
              : rolling_mass * gravity / 1e6;
    Scene s = scene_of(
        hertz, friction, 0.5, step,
        {body(1, rolling_radius, rolling_mass, {{0, 0, rolling_radius - overlap}}, {{speed, 0, 0}})});
    add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
    add_body_force(s, "gravity", {{"acceleration", {0, 0, -gravity}}});
    Simulation simulation(s);
    const auto run_until = [&](double t) {
      run(simulation, std::uint64_t(std::round(t / step)) - simulation.steps());
    };
    // The spring is loaded within the first step, and the normal force settles within ten contact times, 5e-3
    // s, from an excess of less than 2 %.
    const double settling = (step + 5e-3 * 0.02) * braking;
    run_until(0.98 * time);
    CHECK(velocity(simulation, 0)[0] == Approx(speed - braking * 0.98 * time).margin(settling));
    CHECK(simulation.contact_list().sliding[0]);
    run_until(1.05 * time);
    CHECK_FALSE(simulation.contact_list().sliding[0]);
    // The spring is released where slip ends: its energy is μ² m² g²/(2 k_t), 2e-8 J of 3.6e-3 J.
    const double rolling = 5 * speed / 7;
    run_until(1.5 * time);
    CHECK(velocity(simulation, 0)[0] == Approx(rolling).epsilon(1e-5));
    // By 20 radii; the points are painted anew every 0.1 radii, and nothing brakes.
    run_until(1.5 * time + 20 * rolling_radius / rolling);
    const double later = velocity(simulation, 0)[0];
    CHECK(later == Approx(rolling).epsilon(1e-5));
    CHECK(rolling_radius * simulation.particles().body(0).spin[1] == Approx(later).epsilon(1e-9));
    CHECK(simulation.energy().elastic_tangential < 1e-15 * kinetic(simulation.energy()));
  }
}

TEST_CASE("rolling far with a spin about the normal costs spheres what `describe` states", "[sphere]") {
  // 50 radii. Within 0.1 rad of rolling the spring follows the twist; kept up to 0.35 rad it took 99.96 % of
  // the spin and y/R = 0.36.
  constexpr double size = 0.005, weight = 1e-3, gravity = 9.81, speed = 0.5, step = 1e-5;
  const auto rolled = [&](double stiffness) {
    const Values values = {{"normal_stiffness", {5 * stiffness}},
                           {"normal_damping", {0.05}},
                           {"tangential_stiffness", {stiffness}},
                           {"tangential_damping", {0.01}},
                           {"static_friction", {0.5}}};
    Body sphere = body(1, size, weight, {{0, 0, size - weight * gravity / (5 * stiffness)}}, {{speed, 0, 0}},
                       {{0, speed / size, 20}});
    const double h = stiffness > 1e4 ? 2e-6 : step;
    Scene s = scene(3, h, {sphere}, values, "sphere_path_independent");
    add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
    add_body_force(s, "gravity", {{"acceleration", {0, 0, -gravity}}});
    Simulation simulation(s);
    run(simulation, std::uint64_t(std::round(50 * size / speed / h)));
    return simulation.particles().body(0);
  };
  // Within a tenth of the loss: the last painting is anywhere within 0.1 of 50 rad.
  const Body soft = rolled(1e3), stiff = rolled(1e5);
  CHECK(1 - soft.spin[2] / 20 == Approx(0.03).margin(0.003));
  CHECK(soft.position[1] / size == Approx(0.14).margin(0.014));
  CHECK(1 - stiff.spin[2] / 20 == Approx(0.72).margin(0.07));
  // Coulomb's limit times the longest arc.
  const double braking = 0.5 * weight * gravity * 0.1 * size / (0.4 * weight * size * size);
  CHECK(stiff.spin[2] > 20 - braking * 50 * size / speed);
}
