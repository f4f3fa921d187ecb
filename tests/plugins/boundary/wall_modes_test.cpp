#include "wall_support.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include <scree/energy.hpp>

// Each mode of a wall of `plane` and `box` against its closed form; changes between modes are in
// wall_switches_test.cpp. A velocity that is 0 or constant, and a constant force, are exact up to round-off.

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

// A plane of normal z at z = 0.2, far from a body.
Simulation moved_plane(const Values& motion, double step) {
  Scene sc = scene(3, step, {body(1, 0.01, 0.01, {{0, 0, 5}})}, elastic);
  Values values = {{"point", {0, 0, 0.2}}, {"normal", {0, 0, 2}}};
  values.insert(values.end(), motion.begin(), motion.end());
  add_boundary(sc, "plane", values);
  return Simulation(sc);
}
double raised(const Simulation& s) { return s.planes()[0].point[2] - 0.2; }

// A box from −0.1 to 0.1 m, fixed but for what `motion` says, around a body that touches nothing.
Simulation moved_box(const Values& motion, double step) {
  Scene sc = scene(3, step, {body(1, 0.001, 0.01, {})}, elastic);
  Values values = {
      {"lower", {-0.1, -0.1, -0.1}}, {"upper", {0.1, 0.1, 0.1}}, {"y", {box_fixed}}, {"z", {box_fixed}}};
  values.insert(values.end(), motion.begin(), motion.end());
  add_boundary(sc, "box", values);
  return Simulation(sc);
}
double length_x(const Simulation& s) { return s.planes()[1].point[0] - s.planes()[0].point[0]; }

}  // namespace

TEST_CASE("a plane of prescribed velocity moves by the integral of it", "[plane]") {
  const double step = 1e-3;
  SECTION("constant, from the first instant") {
    Simulation s = moved_plane({{"control", {plane_velocity}}, {"velocity", {0, 0.3}}}, step);
    CHECK(speed_of_wall(s) == 0.3);
    run(s, 500);
    CHECK(raised(s) == Approx(0.15).margin(500 * unit_round_off));
    CHECK(speed_of_wall(s) == 0.3);
  }
  SECTION("ramp: exact, because Simpson's rule is for cubic polynomials") {
    Simulation s = moved_plane({{"control", {plane_velocity}}, {"velocity", {3, 0, 0.4, 0.5}}}, step);
    run(s, 500);
    CHECK(raised(s) == Approx(0.5 * 0.4 * 0.5).margin(500 * unit_round_off));
    CHECK(speed_of_wall(s) == Approx(0.4));
  }
  SECTION("sine") {
    const double frequency = 5, amplitude = 0.2, omega = 2 * pi * frequency;
    Simulation s =
        moved_plane({{"control", {plane_velocity}}, {"velocity", {1, 0, amplitude, frequency, 0}}}, step);
    run(s, 70);
    // Simpson's rule: (ωh)⁴/2880 of the integral, and 1 % for higher orders.
    CHECK(raised(s) == Approx(amplitude / omega * (1 - std::cos(omega * 0.07)))
                           .epsilon(1.01 * std::pow(omega * step, 4) / 2880));
    CHECK(speed_of_wall(s) == Approx(amplitude * std::sin(omega * 0.07)));
  }
}

TEST_CASE("a plane under a force or a stress obeys m s'' = P − γ s'", "[plane]") {
  const double m = 2, gamma = 200, force = 10, step = 1e-5;
  const auto pressed = GENERATE(Values{{"control", {plane_force}}, {"force", {0, 10}}},
                                Values{{"control", {plane_stress}}, {"stress", {0, 1000}}, {"area", {0.01}}});
  Values values = pressed;
  values.insert(values.end(), {{"mass", {m}}, {"viscosity", {gamma}}});
  Simulation s = moved_plane(values, step);
  run(s, 2000);
  const double terminal = force / gamma, rate = gamma / m, t = s.time();
  // Step error: (γΔt/m)²/12 = 1e-7 relative.
  CHECK(raised(s) == Approx(terminal * (t - (1 - std::exp(-rate * t)) / rate)).epsilon(1e-6));
  CHECK(speed_of_wall(s) == Approx(terminal * (1 - std::exp(-rate * t))).epsilon(1e-6));
  CHECK(std::abs(s.energy().residual) < 1e-6 * s.energy().work);
}

TEST_CASE("a superposed displacement is added to the motion that a constant force gives", "[plane]") {
  const double m = 2, force = 10, step = 1e-4, amplitude = 1e-3, frequency = 20, omega = 2 * pi * frequency;
  Simulation s = moved_plane({{"control", {plane_force}},
                              {"force", {0, force}},
                              {"mass", {m}},
                              {"superposed", {1, 0.7, amplitude, frequency, 0}}},
                             step);
  CHECK(speed_of_wall(s) == Approx(amplitude * omega));
  run(s, 1234);
  const double t = s.time();
  // Uniform acceleration is exact in velocity Verlet: sums of 1234 terms, rounded.
  CHECK(raised(s) ==
        Approx(0.5 * force / m * t * t + amplitude * std::sin(omega * t)).margin(1234 * unit_round_off));
  CHECK(speed_of_wall(s) == Approx(force / m * t + amplitude * omega * std::cos(omega * t)).epsilon(1e-12));
  // Nothing resists the superposed motion: all work is that of the force.
  const scree_energy e = s.energy();
  CHECK(e.kinetic_boundary == Approx(0.5 * m * std::pow(force / m * t, 2)).epsilon(1e-12));
  CHECK(std::abs(e.residual) < 1e-12 * e.work);
}

TEST_CASE("walls that press on a body and shake are forced oscillators", "[box]") {
  // Both walls press on one body and shake alike, so that the body rests and s'' = −ω₀² (s + d), ω₀² = k/m.
  const double k = 1e4, m = 0.5, radius = 0.01, pressure = 1000, area = 0.04, step = 2e-5, amplitude = 1e-5,
               frequency = 15;
  const double natural = std::sqrt(k / m), omega = 2 * pi * frequency;
  const double overlap = pressure * area / k, half = radius - overlap;
  Scene sc = scene(3, step, {body(1, radius, 0.01, {})}, elastic);
  const std::vector<double> shake = {1, 0, amplitude, frequency, 0};
  add_boundary(sc, "box",
               {{"lower", {-half, -0.1, -0.1}},
                {"upper", {half, 0.1, 0.1}},
                {"y", {box_fixed}},
                {"z", {box_fixed}},
                {"stress", {0, pressure}},
                {"mass", {m}},
                {"superposed_x_low", shake},
                {"superposed_x_high", shake}});
  Simulation s(sc);
  const double force = amplitude * natural * natural / (natural * natural - omega * omega);
  for (int n = 0; n < 5; ++n) {
    run(s, 1000);
    const double t = s.time();
    const double free = -force * (std::sin(omega * t) - omega / natural * std::sin(natural * t));
    const double inwards = free + amplitude * std::sin(omega * t);
    // Velocity Verlet: the phase is off by ω₀ t (ω₀h)²/24, the forced amplitude by (ω₀h)²/4 of itself.
    const double phase = natural * step;
    const double tolerance = force * (natural * t * phase * phase / 24 + phase * phase / 4);
    CHECK(s.planes()[0].point[0] == Approx(-half + inwards).margin(tolerance));
    CHECK(s.planes()[1].point[0] == Approx(half - inwards).margin(tolerance));
  }
  CHECK(position(s, 0) == Vec3{});
  const scree_energy e = s.energy();
  // The energy of a velocity-Verlet oscillator fluctuates by (ω₀h)²/4; what is exchanged is below k
  // (overlap)².
  CHECK(std::abs(e.residual) < 0.25 * std::pow(natural * step, 2) * k * overlap * overlap);
  CHECK(e.kinetic_boundary > 0);
}

TEST_CASE("a superposed motion does the work that the contacts take up", "[plane]") {
  // An elastic body between a fixed floor and a pressed, shaken lid.
  const double step = 1e-6, k = 1e4, weight = 20, radius = 0.01;
  Scene sc = scene(3, step, {body(1, radius, 0.01, {{0, 0, radius - weight / k}})}, elastic);
  add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}}, "floor");
  add_boundary(sc, "plane",
               {{"point", {0, 0, 2 * (radius - weight / k)}},
                {"normal", {0, 0, -1}},
                {"control", {plane_force}},
                {"force", {0, weight}},
                {"mass", {0.3}},
                {"superposed", {1, 0, 2e-4, 80, 0}}},
               "lid");
  Simulation s(sc);
  run(s, 20000);
  const scree_energy e = s.energy();
  REQUIRE(std::abs(e.work) > 1e-4);
  // The fastest mode has ω² = 2k/m = (1.4e3/s)²: (ωh)²/4 = 5e-7 of the energies, which are of the order of
  // the work.
  CHECK(std::abs(e.residual) < 5e-7 * (std::abs(e.work) + weight * weight / k));
}

TEST_CASE("a strain rate changes the length of the box as prescribed, exactly", "[box]") {
  const double rate = 0.8, step = 1e-3;
  SECTION("both walls, about the middle") {
    Simulation s = moved_box({{"x", {box_strain_rate}}, {"strain_rate_x", {0, rate}}}, step);
    CHECK(s.planes()[0].velocity[0] == Approx(0.5 * rate * 0.2));
    run(s, 500);
    CHECK(length_x(s) == Approx(0.2 * std::exp(-rate * 0.5)).epsilon(500 * 2 * unit_round_off));
    CHECK(s.planes()[0].point[0] == Approx(-s.planes()[1].point[0]).epsilon(500 * unit_round_off));
    CHECK(s.planes()[1].velocity[0] == Approx(-0.5 * rate * length_x(s)));
  }
  SECTION("one wall alone, in extension, with a program") {
    Simulation s = moved_box(
        {{"x_low", {box_fixed}}, {"x_high", {box_strain_rate}}, {"strain_rate_x", {3, 0, -rate, 0.5}}}, step);
    run(s, 500);
    CHECK(length_x(s) == Approx(0.2 * std::exp(0.5 * rate * 0.5)).epsilon(500 * 2 * unit_round_off));
    CHECK(s.planes()[0].point[0] == -0.1);
  }
}

TEST_CASE("each wall of a box can follow its own displacement or velocity, inwards", "[box]") {
  Simulation s = moved_box({{"x_low", {box_displacement}},
                            {"displacement_x_low", {3, 0, 0.02, 0.1}},
                            {"x_high", {box_velocity}},
                            {"velocity_x_high", {0, -0.3}}},
                           1e-3);
  run(s, 100);
  CHECK(s.planes()[0].point[0] == Approx(-0.08).margin(100 * unit_round_off));
  CHECK(s.planes()[1].point[0] == Approx(0.13).margin(100 * unit_round_off));
}

TEST_CASE("a wall that pushes a body by a prescribed velocity does the work", "[box]") {
  const double v = 0.5;
  Scene sc = scene(3, 1e-6, {body(1, 0.01, 0.01, {{0.0101, 0, 0}})}, elastic);
  add_boundary(sc, "box",
               {{"lower", {0, -1, -1}},
                {"upper", {5, 1, 1}},
                {"x_low", {box_velocity}},
                {"velocity_x_low", {0, v}},
                {"x_high", {box_fixed}},
                {"y", {box_fixed}},
                {"z", {box_fixed}}});
  Simulation s(sc);
  run(s, 5000);
  // Step error of the corners of the force, (ωΔt)²/8 each, ωΔt = 1e-3.
  CHECK(velocity(s, 0)[0] == Approx(2 * v).epsilon(1e-6));
  CHECK(s.energy().work == Approx(0.5 * 0.01 * 4 * v * v).epsilon(1e-6));
  CHECK(std::abs(s.energy().residual) < 1e-6 * s.energy().work);
}

TEST_CASE("walls without the program that their control needs are refused by name", "[box][plane]") {
  const auto box = [](const Values& v) { return [v] { moved_box(v, 1e-3); }; };
  const auto plane = [](const Values& v) { return [v] { moved_plane(v, 1e-3); }; };
  CHECK_THROWS_WITH(box(Values{{"x", {box_displacement}}})(),
                    Catch::Contains("wall x_low has no displacement; give displacement_x_low = <m>"));
  CHECK_THROWS_WITH(box(Values{{"x_low", {box_fixed}}, {"x_high", {box_velocity}}})(),
                    Catch::Contains("wall x_high has no velocity; give velocity_x_high = <m/s>"));
  CHECK_THROWS_WITH(box(Values{{"x", {box_strain_rate}}})(), Catch::Contains("give strain_rate_x = <1/s>"));
  CHECK_THROWS_WITH(box(Values{{"x_low", {box_strain_rate}},
                               {"strain_rate_x", {0, 1}},
                               {"x_high", {box_velocity}},
                               {"velocity_x_high", {0, 1}}})(),
                    Catch::Contains("the opposite one moves otherwise"));
  CHECK_THROWS_WITH(box(Values{{"x", {box_stress}}})(), Catch::Contains("give stress = <Pa>"));
  CHECK_THROWS_WITH(box(Values{{"x", {box_fixed}}, {"x_low", {box_fixed}}})(),
                    Catch::Contains("x_low and x both say what moves a wall"));
  CHECK_THROWS_WITH(plane(Values{{"control", {plane_displacement}}})(),
                    Catch::Contains("give displacement = <m>"));
  CHECK_THROWS_WITH(plane(Values{{"control", {plane_velocity}}})(), Catch::Contains("give velocity = <m/s>"));
  CHECK_THROWS_WITH(plane(Values{{"control", {plane_stress}}, {"stress", {0, 1}}})(),
                    Catch::Contains("area = <m^2>"));
  CHECK_THROWS_WITH(plane(Values{{"control", {plane_force}}})(), Catch::Contains("give force = <N>"));
}
