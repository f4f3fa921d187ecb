#include "surface_support.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/energy.hpp>
#include <scree/error.hpp>
#include <scree/plugin/rotation.hpp>

// Surfaces that forces and torques move, against closed forms and planes.

using namespace scree;
using namespace scree::test;

namespace {

// The problem when a scene with this boundary starts.
std::string problem(const std::string& plugin, const Values& values) {
  Scene sc = far_body(1e-5);
  try {
    add_boundary(sc, plugin, values);
    Simulation s(sc);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

TEST_CASE("a disc under a force or a stress moves as a plane does", "[surfaces]") {
  const double area = 0.04 * 3.141592653589793;
  const auto [of_disc, of_plane] = GENERATE_COPY(
      std::pair{Values{{"force", {1, 10, 5, 30, 0}}, {"viscosity", {20}}},
                Values{{"control", {plane_force}}, {"force", {1, 10, 5, 30, 0}}, {"viscosity", {20}}}},
      std::pair{Values{{"stress", {0, 500}}},
                Values{{"control", {plane_stress}}, {"stress", {0, 500}}, {"area", {area}}}},
      std::pair{Values{{"force", {0, -4}}, {"superposed", {3, 0, 0.01, 0.2}}},
                Values{{"control", {plane_force}}, {"force", {0, -4}}, {"superposed", {3, 0, 0.01, 0.2}}}});
  for (const Integration integration :
       {Integration::velocity_verlet, Integration::position_verlet, Integration::fourth_order}) {
    Scene one = scene(3, 1e-4, {body(1, 0.05, 0.5, {{0, 0, 0.05}}, {{0, 0, -0.5}})}, elastic), other = one;
    one.integration = other.integration = integration;
    add_boundary(one, "disc", together(plate, of_disc));
    add_boundary(other, "plane",
                 together({{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"mass", {disc_mass}}}, of_plane));
    Simulation disc(one), plane(other);
    run(disc, 2000);
    run(plane, 2000);
    // Round-off of 2000 steps of a distance below 1 m; the projected area is rounded otherwise.
    CHECK(frame(disc).position[2] == Approx(plane.planes()[0].point[2]).margin(1e-12));
    CHECK(frame(disc).velocity[2] == Approx(plane.planes()[0].velocity[2]).margin(1e-11));
    CHECK(velocity(disc, 0)[2] == Approx(velocity(plane, 0)[2]).margin(1e-11));
    CHECK(disc.energy().kinetic_boundary == Approx(plane.energy().kinetic_boundary).epsilon(1e-11));
    CHECK(disc.energy().residual == Approx(plane.energy().residual).margin(1e-11));
  }
}

TEST_CASE("a stress acts on the area that is seen along the motion", "[surfaces]") {
  constexpr double half_turn = 3.141592653589793,
                   tilt = 0.6;  // cosine of the angle between normal and direction
  const auto area_of = [](int dimension, const std::string& plugin, const Values& shape) {
    Scene sc = scene(dimension, 1e-4, {body(1, 0.01, 0.01, {{0, 9, 0}}, {}, {}, dimension)}, elastic);
    add_boundary(sc, plugin,
                 together(shape, {{"point", {0, 0, 0}}, {"stress", {0, 3}}, {"mass", {disc_mass}}}));
    Simulation s(sc);
    run(s, 100);
    const auto& v = frame(s).velocity;
    return norm(Vec3{{v[0], v[1], v[2]}}) * disc_mass / (3 * s.time());
  };
  const Values tilted = {{"normal", {0, 0, 1}}, {"direction", {0.8, 0, tilt}}};
  const Values across = {{"normal", {0, 1, 0}}, {"length", {0.3}}};
  CHECK(area_of(3, "disc", together(tilted, {{"radius", {0.2}}, {"hole", {0.1}}})) ==
        Approx(half_turn * 0.03 * tilt));
  CHECK(area_of(3, "rectangle",
                together(tilted, {{"along", {1, 0, 0}}, {"length", {0.3}}, {"width", {0.2}}})) ==
        Approx(0.06 * tilt));
  CHECK(area_of(2, "rectangle", together(across, {{"direction", {0.8, tilt, 0}}})) == Approx(0.3 * tilt));
  CHECK(area_of(3, "sphere", {{"radius", {0.2}}}) == Approx(half_turn * 0.04));
  CHECK(area_of(2, "sphere", {{"radius", {0.2}}, {"direction", {1, 0, 0}}}) == Approx(0.4));
  CHECK(area_of(3, "cylinder", {{"radius", {0.2}}, {"area", {0.7}}}) == Approx(0.7));
}

// ω = M/γ (1 − exp(−γ t/I)). Step error: (γ h/I)²/12 = 8e-8.
TEST_CASE("a surface under a torque obeys I φ'' = M − γ φ'", "[surfaces]") {
  constexpr double inertia = 0.02, torque = 0.3, viscosity = 0.2, step = 1e-4;
  Scene sc = far_body(step);
  add_boundary(sc, "cylinder",
               {{"point", {0.3, 0, 0}},
                {"axis", {0, 0, 1}},
                {"radius", {0.1}},
                {"torque", {0, torque}},
                {"inertia", {inertia}},
                {"spin_viscosity", {viscosity}},
                {"spin_axis", {0, 0, 2}},
                {"spin_point", {0.3, 0, 7}}});
  Simulation s(sc);
  run(s, 2000);
  const double rate = viscosity / inertia, last = torque / viscosity;
  CHECK(frame(s).spin[2] == Approx(last * (1 - std::exp(-rate * s.time()))).epsilon(1e-6));
  CHECK(norm(Vec3{{frame(s).velocity[0], frame(s).velocity[1], frame(s).velocity[2]}}) == 0);
  CHECK(s.energy().kinetic_boundary == Approx(0.5 * inertia * frame(s).spin[2] * frame(s).spin[2]));
  CHECK(std::abs(s.energy().residual) < 1e-6 * s.energy().work);
}

// Elastic impacts of a bead on a free disc, and on a plate that turns about an axis at a distance r, which
// has the mass I/r² there. A contact that begins or ends within a step has an energy of at most k (v h)²/2 =
// 8e-6 of the energy too little or too much; the plate turns by 2e-4 rad while it is touched.
TEST_CASE("a bead gives momentum to a surface that is free, and spin to one on a hinge", "[surfaces]") {
  constexpr double mass = 0.5, speed = 0.01, arm = 0.25;
  for (const bool hinge : {false, true}) {
    Scene sc = scene(3, 2e-5, {body(1, 0.05, mass, {{0, 0, 0.0501}}, {{0, 0, -speed}})}, elastic);
    const double inertia = 0.08, other = hinge ? inertia / (arm * arm) : disc_mass;
    if (hinge)
      add_boundary(sc, "rectangle",
                   {{"point", {-0.05, 0, 0}},
                    {"normal", {0, 0, 1}},
                    {"along", {1, 0, 0}},
                    {"length", {0.4}},
                    {"width", {0.4}},
                    {"torque", {0, 0}},
                    {"inertia", {inertia}},
                    {"spin_axis", {0, 1, 0}},
                    {"spin_point", {-arm, 0, 0}}});
    else
      add_boundary(sc, "disc", together(plate, {{"force", {0, 0}}}));
    Simulation s(sc);
    run(s, 4000);
    REQUIRE(position(s, 0)[2] > 0.05);
    const double sum = mass + other;
    CHECK(velocity(s, 0)[2] == Approx(-speed * (mass - other) / sum).epsilon(5e-4));
    const double given = -2 * mass / sum * speed;
    if (hinge)
      CHECK(frame(s).spin[1] == Approx(-given / arm).epsilon(5e-4));
    else
      CHECK(frame(s).velocity[2] == Approx(given).epsilon(1.6e-5));
    const double energy = 0.5 * mass * speed * speed;
    CHECK(s.energy().kinetic_translation + s.energy().kinetic_boundary == Approx(energy).epsilon(1.6e-5));
    CHECK(std::abs(s.energy().residual) < 1.6e-5 * energy);
  }
}

TEST_CASE("a wheel that bodies drive takes up the work that they do", "[surfaces]") {
  // A sphere slides on a turning disc until both turn alike: friction μ m g at the radius r spins up the
  // disc.
  constexpr double step = 1e-5, inertia = 0.05, radius = 0.15, friction = 0.3, weight = 0.1 * 9.81;
  Scene sc = scene(3, step, {body(1, 0.02, 0.1, {{radius, 0, 0.02 - weight / stiffness}}, {{0, 1, 0}})},
                   {{"normal_stiffness", {stiffness}},
                    {"normal_damping", {0}},
                    {"tangential_stiffness", {1e4}},
                    {"static_friction", {friction}}});
  add_boundary(sc, "disc",
               {{"point", {0, 0, 0}},
                {"normal", {0, 0, 1}},
                {"radius", {0.3}},
                {"torque", {0, 0}},
                {"inertia", {inertia}}});
  add_body_force(sc, "gravity", {{"acceleration", {0, 0, -9.81}}});
  Simulation s(sc);
  run(s, 200);
  const double before = frame(s).spin[2], at = s.time();
  run(s, 1000);
  // Sliding along y at x = r; in 0.01 s the sphere goes 1 cm: direction and arm change by (0.01/0.15)²/2.
  CHECK((frame(s).spin[2] - before) / (s.time() - at) ==
        Approx(friction * weight * radius / inertia).epsilon(3e-3));
  CHECK(std::abs(s.energy_residual()) < 1e-6);
}

// A plate that swings about a point beside it moves on a circle about a point that moves along.
TEST_CASE("an angle about a point beside a surface carries it along a circle", "[surfaces]") {
  constexpr double arm = 0.3, rate = 3, angle = 0.4;
  Scene sc = far_body(1e-4);
  add_boundary(sc, "disc",
               together({{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {0.2}}},
                        {{"angle", {1, 0, angle, rate / 6.283185307179586, 0}},
                         {"spin_axis", {0, 1, 0}},
                         {"spin_point", {-arm, 0, 0}},
                         {"velocity", {0, 0.2}},
                         {"direction", {0.6, 0.8, 0}}}));
  Simulation s(sc);
  run(s, 3000);
  const double turned = angle * std::sin(rate * s.time()), speed = angle * rate * std::cos(rate * s.time());
  // Round-off of 3000 steps.
  CHECK(frame(s).position[0] == Approx(arm * std::cos(turned) - arm + 0.12 * s.time()).margin(1e-12));
  CHECK(frame(s).position[1] == Approx(0.16 * s.time()).margin(1e-12));
  CHECK(frame(s).position[2] == Approx(-arm * std::sin(turned)).margin(1e-12));
  CHECK(frame(s).orientation[2] == Approx(std::sin(turned / 2)).margin(1e-12));
  CHECK(frame(s).spin[1] == Approx(speed).margin(1e-12));
  CHECK(frame(s).velocity[0] == Approx(0.12 - arm * speed * std::sin(turned)).margin(1e-12));
  CHECK(frame(s).velocity[2] == Approx(-arm * speed * std::cos(turned)).margin(1e-12));
}

TEST_CASE("motions of surfaces that cannot be are refused by name", "[surfaces]") {
  const Values disc = {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {0.2}}};
  const Values endless = {{"point", {5, 0, 0}}, {"axis", {0, 0, 1}}, {"radius", {0.2}}};
  CHECK_THAT(problem("disc", together(disc, {{"force", {0, 1}}})), Catch::Contains("mass is missing"));
  CHECK_THAT(problem("disc", together(disc, {{"torque", {0, 1}}})), Catch::Contains("inertia is missing"));
  CHECK_THAT(problem("disc", together(plate, {{"force", {0, 1}}, {"velocity", {0, 1}}})),
             Catch::Contains("without control; say which, such as control = \"force\""));
  CHECK_THAT(problem("disc", together(plate, {{"force", {0, 1}}, {"stress", {0, 1}}})),
             Catch::Contains("without control; say which, such as control = \"stress\""));
  CHECK_THAT(problem("disc", together(disc, {{"spin", {0, 1}}, {"angle", {0, 1}}})),
             Catch::Contains("without spin_control"));
  CHECK_THAT(problem("disc", together(disc, {{"control", {by_velocity}}})), Catch::Contains("give velocity"));
  CHECK_THAT(problem("disc", together(disc, {{"spin_control", {by_torque}}})),
             Catch::Contains("give torque"));
  CHECK_THAT(problem("disc", together(disc, {{"superposed", {0, 1}}})),
             Catch::Contains("superposed on none"));
  CHECK_THAT(problem("cylinder", together(endless, {{"stress", {0, 1}}, {"mass", {1}}})),
             Catch::Contains("give area"));
  CHECK_THAT(problem("cylinder",
                     together(endless, {{"torque", {0, 1}}, {"inertia", {1}}, {"spin_axis", {1, 0, 0}}})),
             Catch::Contains("a surface without end"));
  CHECK(problem("cylinder", together(endless, {{"torque", {0, 1}}, {"inertia", {1}}})) == "nothing");
  CHECK_THAT(problem("disc", together(disc, {{"inertia", {1}}})),
             Catch::Contains("inertia is given without torque; give torque = 0"));
  CHECK_THAT(problem("disc", together(plate, {})), Catch::Contains("give force = 0"));
  CHECK_THAT(problem("disc", together(disc, {{"torque", {0, 1}}, {"inertia", {1e-320}}})),
             Catch::Contains("too small"));
  // What another stage uses may be there.
  CHECK(problem("disc", together(plate, {{"control", {at_rest}}, {"superposed", {0, 1}}})) == "nothing");
  CHECK(problem("disc", together(disc, {{"spin_control", {spin_at_rest}}, {"spin_point", {1, 0, 0}}})) ==
        "nothing");
}

TEST_CASE("a surface that passes bodies within a step ends the run", "[surfaces]") {
  Scene sc = scene(3, 1e-4, {body(1, 0.05, 1, {{1, 0, 1}})}, elastic);
  add_boundary(
      sc, "disc",
      {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {0.2}}, {"velocity", {3, 0, 1e4, 0.1}}});
  Simulation s(sc);
  // Half of the body in a step are 500 m/s, after 5 ms.
  CHECK_THROWS_WITH(run(s, 1000), Catch::Contains("surface disc moves at 5") &&
                                      Catch::Contains("above the limit of 500 m/s"));
}

// Its distance jumps below 0 there, wherever it was measured last.
TEST_CASE("a body that comes behind a surface with one side is found", "[surfaces]") {
  Scene sc = scene(3, 1e-4, {body(1, 0.05, 1, {{1.3, 0, -1}}, {{-10, 0, 0}})}, elastic);
  add_boundary(sc, "disc", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {0.2}}, {"side", {1}}});
  Simulation s(sc);
  run(s, 1050);
  CHECK_THROWS_WITH(run(s, 150), Catch::Contains("contact of particle 1 with wall disc: overlap is"));
}

TEST_CASE("axes near to -z are as good as others", "[surfaces]") {
  for (int k = 0; k <= 17; ++k)
    for (const double turn : {0.0, 0.7, 2.0}) {
      const double tilt = std::pow(10.0, -k);
      const Vec3 given = {{tilt * std::cos(turn), tilt * std::sin(turn), -1}}, axis = 1 / norm(given) * given;
      // Round-off of some operations.
      CHECK(norm(Rotation::from_z_to(axis)(Vec3{{0, 0, 1}}) - axis) < 10 * unit_round_off);
      const Vec3 x = {{-std::cos(tilt), -std::sin(tilt), 0}};
      const Rotation both = Rotation::to_axes(x, {{0, 0, 1}});
      CHECK(norm(both(Vec3{{1, 0, 0}}) - x) < 10 * unit_round_off);
      CHECK(norm(both(Vec3{{0, 0, 1}}) - Vec3{{0, 0, 1}}) < 10 * unit_round_off);
    }
}
