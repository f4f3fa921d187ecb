#include "wall_support.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include <scree/energy.hpp>

// A stage may change what moves a wall: positions are continuous, velocities as plugins/README.md says, and
// the energy balance stays closed.

using namespace scree;
using namespace scree::test;

namespace {

struct Control {
  std::string name;
  Values values;
  double starts_with;  // (m/s) the speed at once; NaN: the speed that the wall has
};

const Values base = {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"mass", {2}}};
const double same = std::nan("");
const Control controls[] = {{"fixed", {{"control", {0}}}, 0},
                            {"displacement", {{"control", {1}}, {"displacement", {3, 0.5, 0.7, 0.1}}}, 2},
                            {"velocity", {{"control", {2}}, {"velocity", {0, -3}}}, -3},
                            {"velocity from rest", {{"control", {2}}, {"velocity", {3, 0, 1, 0.1}}}, 0},
                            {"stress", {{"control", {3}}, {"stress", {0, 500}}, {"area", {0.02}}}, same},
                            {"force", {{"control", {4}}, {"force", {0, -30}}, {"viscosity", {3}}}, same}};

Values with(const Values& added) {
  Values all = base;
  all.insert(all.end(), added.begin(), added.end());
  return all;
}
void change(Simulation& s, const std::string& plugin, const Values& values) {
  s.reconfigure_boundary(plugin, parameters(plugin, SCREE_BOUNDARY, values));
  s.apply_reconfiguration();
}

}  // namespace

TEST_CASE("between any two controls the position is continuous and the energy balance stays closed",
          "[plane]") {
  constexpr double step = 1e-4, m = 2, gamma = 3, strongest = 30, acceleration = strongest / m;
  for (const Integration integration : {Integration::velocity_verlet, Integration::position_verlet})
    for (const Control& before : controls)
      for (const Control& after : controls) {
        INFO(before.name << " to " << after.name);
        Scene sc = scene(3, step, {body(1, 0.01, 0.01, {{0, 0, 9}})}, elastic);
        sc.integration = integration;
        add_boundary(sc, "plane", with(before.values));
        Simulation s(sc);
        run(s, 200);
        const double old_height = height_of_wall(s), old_speed = speed_of_wall(s);
        change(s, "plane", with(after.values));
        // In position_verlet the wall is half a step ahead of the forces until the change.
        const double ahead = integration == Integration::position_verlet ? 0.5 * step * acceleration : 0;
        CHECK(height_of_wall(s) == Approx(old_height).margin(2 * unit_round_off + 0.5 * step * ahead));
        const bool pressed = std::isnan(after.starts_with);
        CHECK(speed_of_wall(s) == Approx(pressed ? old_speed : after.starts_with).margin(ahead));
        CHECK(s.energy().kinetic_boundary ==
              Approx(pressed ? 0.5 * m * speed_of_wall(s) * speed_of_wall(s) : 0).margin(1e-15));
        run(s, 1);
        CHECK(std::abs(height_of_wall(s) - old_height) <=
              step * (std::abs(speed_of_wall(s)) + 2 * step * acceleration));
        run(s, 200);
        // Round-off of 400 terms of 9 J. Under viscosity the sums are off by γh(Ph/2m)² a step, and by
        // (γh/m)²/2 of what is dissipated.
        CHECK(std::abs(s.energy().residual) <
              9 * (400 * 2 * unit_round_off + std::pow(gamma * step / m, 2) / 2) +
                  s.time() * gamma * std::pow(acceleration * step / 2, 2));
      }
}

TEST_CASE("a jump of stress counts from the instant of the jump", "[plane]") {
  // A constant acceleration is exact, so that work, kinetic energy and residual are too. Work with the stress
  // of before in the first step would be off by Δp A v h/2.
  const double step = 1e-4, v = 10 / 2.0 * 0.02;
  Scene sc = scene(3, step, {body(1, 0.01, 0.01, {{0, 0, 9}})}, elastic);
  add_boundary(sc, "plane", with({{"control", {4}}, {"force", {0, 10}}}));
  Simulation s(sc);
  run(s, 200);
  change(s, "plane", with({{"control", {4}}, {"force", {0, 500}}}));
  run(s, 1);
  REQUIRE(490 * v * step / 2 > 1e-6);
  CHECK(std::abs(s.energy().residual) < 1e-13);
}

TEST_CASE("a superposed motion that begins or ends leaves the motion under stress as it is", "[plane]") {
  const Values pressed = with({{"control", {4}}, {"force", {0, 10}}});
  Values shaken = pressed;
  shaken.push_back({"superposed", {1, 0, 1e-3, 50, 0}});
  Scene sc = scene(3, 1e-4, {body(1, 0.01, 0.01, {{0, 0, 9}})}, elastic);
  add_boundary(sc, "plane", pressed);
  Simulation s(sc);
  run(s, 100);
  change(s, "plane", shaken);
  CHECK(speed_of_wall(s) == Approx(5 * 0.01 + 1e-3 * 2 * 3.14159265358979 * 50));
  run(s, 200);  // a period
  change(s, "plane", pressed);
  CHECK(speed_of_wall(s) == Approx(5 * 0.03));
  run(s, 100);
  // x = P t²/2m; the displacement had come back to 0.
  CHECK(height_of_wall(s) == Approx(0.5 * 5 * 0.04 * 0.04).margin(400 * unit_round_off));
  CHECK(std::abs(s.energy().residual) < 400 * 2 * unit_round_off);
}

TEST_CASE("a loaded wall of a box goes from stress to strain rate and back", "[box]") {
  // An elastic body between two walls. Nothing dissipates, so that the balance is that of velocity Verlet.
  const double step = 1e-6, k = 1e5, radius = 0.01, pressure = 1000, m = 0.05;
  const double half = radius - pressure * 0.04 / k;
  const auto with_x = [&](const Values& x) {
    Values all = {{"lower", {-half, -0.1, -0.1}},
                  {"upper", {half, 0.1, 0.1}},
                  {"y", {1}},
                  {"z", {1}},
                  {"stress", {0, pressure}},
                  {"mass", {m}}};
    all.insert(all.end(), x.begin(), x.end());
    return all;
  };
  Scene sc =
      scene(3, step, {body(1, radius, 0.01, {})}, {{"normal_stiffness", {k}}, {"normal_damping", {0}}});
  add_boundary(sc, "box", with_x({{"x", {0}}}));
  Simulation s(sc);
  const Values strained = with_x({{"x", {4}}, {"strain_rate_x", {3, 0, 2, 5e-3}}});
  const Values more = with_x({{"x", {0}}, {"stress_x", {0, 2 * pressure}}});
  run(s, 1000);
  for (const Values& next : {strained, more, strained, with_x({{"x", {1}}}), more}) {
    const double at = s.planes()[1].point[0];
    change(s, "box", next);
    CHECK(s.planes()[1].point[0] == at);
    run(s, 5000);
  }
  const scree_energy e = s.energy();
  REQUIRE(e.work != 0);
  // The fastest control has ω² = 2k/M = (4.5e3/s)²: (ωh)²/4 of energies of up to k (2δ)².
  CHECK(std::abs(e.residual) < 0.25 * std::pow(4.5e3 * step, 2) * k * std::pow(2 * (radius - half), 2));
}

TEST_CASE("a change of mass in motion is work, not an error of the balance", "[plane]") {
  Scene sc = scene(3, 1e-4, {body(1, 0.01, 0.01, {{0, 0, 9}})}, elastic);
  add_boundary(sc, "plane", with({{"control", {4}}, {"force", {0, 10}}}));
  Simulation s(sc);
  run(s, 200);
  Values heavier = with({{"control", {4}}, {"force", {0, 10}}});
  heavier[2].second = {7};
  change(s, "plane", heavier);
  CHECK(s.energy().kinetic_boundary == Approx(0.5 * 7 * speed_of_wall(s) * speed_of_wall(s)));
  CHECK(std::abs(s.energy().residual) < 1e-15);
}
