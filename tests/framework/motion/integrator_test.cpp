#include "numbers.hpp"
#include "scenes.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using scree::Body;
using scree::Scene;
using scree::Simulation;
using scree::Vec3;
using scree::test::epsilon;
using scree::test::Values;

namespace {

Values linear_spring(double stiffness, double damping = 0) {
  return {{"normal_stiffness", {stiffness}}, {"normal_damping", {damping}}};
}

// A body on a horizontal plane with weight m g; it rests at overlap m g/k and oscillates about it while in
// contact.
Scene on_a_plane(double step, const Body& body, const Values& law, double gravity, int dimension = 3) {
  Scene s = scree::test::scene(dimension, step, {body}, law);
  const bool flat = dimension == 2;
  scree::test::add_boundary(s, "plane",
                            {{"point", {0, 0, 0}}, {"normal", {0, flat ? 1.0 : 0.0, flat ? 0.0 : 1.0}}});
  scree::test::add_body_force(s, "gravity",
                              {{"acceleration", {0, flat ? -gravity : 0, flat ? 0 : -gravity}}});
  return s;
}

void negate_velocities(Simulation& s) {
  // The simulation itself is not const; only its accessor is.
  auto& particles = const_cast<scree::Particles&>(s.particles());
  for (const auto& vectors : {particles.velocity(), particles.spin()})
    for (int k = 0; k < 3; ++k)
      for (double& x : vectors[k]) x = -x;
}

}  // namespace

TEST_CASE("free flight is exact") {
  for (const int dimension : {2, 3}) {
    // Velocity × step is a multiple of 2^-12 and every position of 2^-20 below 2^20: no rounding occurs.
    const Vec3 x = {{3.25, -17.5, dimension == 3 ? 0.125 : 0}}, v = {{0.5, -3.75, dimension == 3 ? 2.25 : 0}};
    const Vec3 spin = {{dimension == 3 ? 0.3 : 0, dimension == 3 ? -0.7 : 0, 1.1}};
    const double step = 1.0 / 1024;
    Simulation s(scree::test::scene(dimension, step, {scree::test::body(0, 1, 3, x, v, spin, dimension)},
                                    linear_spring(1)));
    scree::test::run(s, 5000);
    const Body body = s.particles().body(0);
    CHECK(body.position == x + (5000 * step) * v);
    CHECK(body.velocity == v);
    CHECK(body.spin == spin);
    CHECK(s.time() == 5000 * step);
  }
}

TEST_CASE("a projectile is on its parabola at the end of each step") {
  const Vec3 x = {{0, 0, 100}}, v = {{3, 0, 20}};
  const double step = 0.01, gravity = 9.81;
  Scene scene = scree::test::scene(3, step, {scree::test::body(0, 0.5, 2, x, v)}, linear_spring(1));
  scree::test::add_body_force(scene, "gravity", {{"acceleration", {0, 0, -gravity}}});
  Simulation s(scene);
  for (int n = 1; n <= 400; ++n) {
    s.step();
    const double t = n * step;
    // Two roundings of the height, 120 m at most, and two of the velocity, 20 m/s, in each step; those of the
    // velocity act for the rest of the time.
    const double allowed = n * epsilon * (2 * 120 + 2 * 20 * t);
    REQUIRE(std::abs(scree::test::position(s, 0)[2] - (x[2] + v[2] * t - 0.5 * gravity * t * t)) <= allowed);
    REQUIRE(std::abs(scree::test::position(s, 0)[0] - v[0] * t) <= allowed);
    REQUIRE(std::abs(scree::test::velocity(s, 0)[2] - (v[2] - gravity * t)) <= 2 * n * epsilon * 20);
  }
}

TEST_CASE("harmonic motion has the frequency with sin(w' h/2) = w h/2 and no other error") {
  // A pair between two walls, in antiphase: each body is bound by its wall's spring and twice that of the
  // pair.
  const double stiffness = 100, mass = 2, radius = 1, squeeze = 0.125, amplitude = 0.0625;
  const double omega = std::sqrt(3 * stiffness / mass);
  for (const double omega_step : {0.01, 0.1, 0.5, 1.0, 1.9}) {
    const double step = omega_step / omega, shifted = 2 * std::asin(omega_step / 2) / step;
    const double rest = radius - squeeze / 2;  // distance of each from the middle
    // At rest the walls exert k δ_w = k × squeeze.
    const double wall = rest + radius - squeeze;
    Scene scene = scree::test::scene(2, step,
                                     {scree::test::body(0, radius, mass, {{-rest - amplitude, 5, 0}}),
                                      scree::test::body(1, radius, mass, {{rest + amplitude, 5, 0}})},
                                     linear_spring(stiffness));
    scree::test::add_boundary(scene, "plane", {{"point", {-wall, 0, 0}}, {"normal", {1, 0, 0}}}, "left");
    scree::test::add_boundary(scene, "plane", {{"point", {wall, 0, 0}}, {"normal", {-1, 0, 0}}}, "right");
    Simulation s(scene);
    const int steps = 2000;
    double worst = 0;
    for (int n = 1; n <= steps; ++n) {
      s.step();
      const double expected = amplitude * std::cos(shifted * n * step);
      worst = std::max(worst, std::abs(scree::test::position(s, 1)[0] - rest - expected));
    }
    // Each step adds a few roundings of coordinates of about 2 m; in the worst case all shift the phase in
    // the same direction, which displaces the body by n²/2 of them, and at ω h near 2 oscillators are 1/√(1 −
    // (ωh/2)²) softer.
    const double softness = 1 / std::sqrt(1 - omega_step * omega_step / 4);
    CHECK(worst <= 4 * epsilon * 2 * 0.5 * steps * steps * omega_step * softness);
    CHECK(worst < 1e-3 * amplitude);
  }
}

TEST_CASE("damped motion converges with the second order of the step") {
  // x = x_eq + A e^(−ηt)(cos ω₁t + η/ω₁ sin ω₁t), at rest at the start.
  const double stiffness = 1000, mass = 1, damping = 20, gravity = 10, amplitude = 0.002, radius = 1;
  const double eta = damping / (2 * mass), omega = std::sqrt(stiffness / mass - eta * eta), time = 0.128;
  const double rest = radius - mass * gravity / stiffness;
  const auto error = [&](double step) {
    Simulation s(on_a_plane(step, scree::test::body(0, radius, mass, {{0, 0, rest + amplitude}}),
                            linear_spring(stiffness, damping), gravity));
    scree::test::run(s, std::uint64_t(std::llround(time / step)));
    const double exact = rest + amplitude * std::exp(-eta * time) *
                                    (std::cos(omega * time) + eta / omega * std::sin(omega * time));
    return scree::test::position(s, 0)[2] - exact;
  };
  // The next term of the error is smaller by about ω h: 0.06 and 0.03 here. The bound leaves it a factor
  // of 4.
  const double coarse = error(0.002), medium = error(0.001), fine = error(0.0005);
  CHECK(coarse / medium == Approx(4).epsilon(0.25));
  CHECK(medium / fine == Approx(4).epsilon(0.12));
}

TEST_CASE("frictionless motion returns to its start when velocities are reversed") {
  // Three spheres that collide with each other and with a wall.
  std::vector<Body> bodies = {scree::test::body(0, 1, 1, {{0, 0, 2}}, {{1, 0.2, -1}}),
                              scree::test::body(1, 0.7, 0.5, {{3, 0.5, 1.5}}, {{-2, 0, 0.1}}),
                              scree::test::body(2, 0.8, 2, {{1, 0.3, 4}}, {{0, 0, -2}})};
  Scene scene = scree::test::scene(3, 1e-3, bodies, linear_spring(1e4));
  scree::test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  const auto there_and_back = [&](double nudge) {
    Simulation s(scene);
    scree::test::run(s, 1500);
    const bool collided = norm(scree::test::velocity(s, 0) - bodies[0].velocity) > 0.1;
    negate_velocities(s);
    const auto x = const_cast<scree::Particles&>(s.particles()).position()[0];
    x[0] += nudge;
    scree::test::run(s, 1500);
    double away = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      away = std::max(away, norm(scree::test::position(s, i) - bodies[i].position));
    REQUIRE(collided);
    return away;
  };
  // A rounding of a coordinate, up to an ulp of 8 m, in each of the 3000 steps grows like a perturbation.
  const double nudge = 1e-9, growth = std::max(1.0, there_and_back(nudge) / nudge);
  REQUIRE(growth < 1e4);
  CHECK(there_and_back(0) <= 4 * growth * 3000 * epsilon * 8);
}

TEST_CASE("a sticking spring on a plane returns to its start when velocities are reversed") {
  // On a plane the normal is constant, so that projections are exact and only the mid-step rule is tested.
  const double stiffness = 1000, mass = 1, radius = 1, gravity = 10, step = 1e-3;
  const Body body = scree::test::body(0, radius, mass, {{0, 0, radius - mass * gravity / stiffness - 0.001}},
                                      {{0.02, -0.01, 0}}, {{0.03, 0.05, 0.01}});
  Values law = linear_spring(stiffness);
  law.insert(law.end(), {{"tangential_stiffness", {800}}, {"static_friction", {1e6}}});
  Simulation s(on_a_plane(step, body, law, gravity));
  scree::test::run(s, 700);
  CHECK(std::abs(scree::test::velocity(s, 0)[0] - 0.02) > 0.001);
  negate_velocities(s);
  scree::test::run(s, 700);
  const Body back = s.particles().body(0);
  // Bounded oscillations: roundings of a coordinate of 1 m add up to n²ωh/2 of them at worst, ω h < 0.06.
  const double allowed = 4 * epsilon * 0.5 * 1400 * 1400 * 0.06;
  CHECK(norm(back.position - body.position) <= allowed);
  CHECK(norm(back.velocity + body.velocity) <= allowed * 60);
  CHECK(norm(back.spin + body.spin) <= allowed * 60);
}

TEST_CASE("a constant torque gives a constant angular acceleration") {
  // A body that slides along a plane under its weight: friction is μ m g, its arm R − δ/2.
  const double stiffness = 1e5, mass = 2, radius = 0.5, gravity = 10, friction = 0.2, speed = 5, step = 1e-3;
  for (const int dimension : {2, 3}) {
    const double overlap = mass * gravity / stiffness, height = radius - overlap;
    const Body body =
        scree::test::body(0, radius, mass, {{0, dimension == 2 ? height : 0, dimension == 3 ? height : 0}},
                          {{speed, 0, 0}}, {}, dimension);
    Values law = linear_spring(stiffness);
    law.insert(law.end(), {{"tangential_stiffness", {1e6}}, {"static_friction", {friction}}});
    Simulation s(on_a_plane(step, body, law, gravity, dimension));
    // Rolling without sliding begins after v₀/(μ g (1 + m R²/I)) > 0.7 s.
    const int steps = 600;
    scree::test::run(s, steps);
    // At the start the spring is not stretched yet: half a step without friction.
    const double slid = (steps - 0.5) * step, torque = friction * mass * gravity * (radius - overlap / 2);
    const Body now = s.particles().body(0);
    // Roundings of the height, an ulp of 0.5 m, change the normal force by k times that: 1e5 × 1e-16 of 20 N
    // per step.
    const double relative = 8 * epsilon * (steps + stiffness * 0.5 / (mass * gravity) * steps);
    const double spin = dimension == 2 ? -now.spin[2] : now.spin[1];
    CHECK(std::abs(spin / (torque * slid / body.inertia) - 1) <= relative);
    CHECK(std::abs((speed - now.velocity[0]) / (friction * gravity * slid) - 1) <= relative);
  }
}

// The acceleration is constant before and after: all integrators are exact, but for n roundings.
TEST_CASE("a force that a stage switches on acts in full from then on") {
  constexpr double g = 10, step = 1e-3;
  constexpr int steps = 100;
  for (const scree::Integration integration :
       {scree::Integration::velocity_verlet, scree::Integration::position_verlet,
        scree::Integration::predictor_corrector, scree::Integration::fourth_order}) {
    Scene scene = scree::test::scene(3, step, {scree::test::body(1, 1, 1, {})}, linear_spring(1));
    scree::test::add_body_force(scene, "gravity", {{"acceleration", {0, 0, 0}}});
    scene.integration = integration;
    Simulation s(scene);
    scree::test::run(s, steps);
    s.reconfigure_body_force(
        "gravity", scree::test::parameters("gravity", SCREE_BODY_FORCE, {{"acceleration", {0, 0, -g}}}));
    s.apply_reconfiguration();
    scree::test::run(s, steps);
    INFO("integrator " << int(integration));
    const double time = steps * step;
    CHECK(std::abs(s.particles().body(0).velocity[2] + g * time) < steps * epsilon * g * time);
    CHECK(std::abs(s.particles().body(0).position[2] + 0.5 * g * time * time) < steps * epsilon * g * time);
  }
}

TEST_CASE("a step that is observed after its substeps ends in the same bits", "[integrator]") {
  for (const scree::IntegrationTraits& traits : scree::integrations()) {
    CAPTURE(traits.name);
    const Values law = {{"normal_stiffness", {1000}},
                        {"normal_damping", {1}},
                        {"tangential_stiffness", {300}},
                        {"static_friction", {0.3}}};
    Scene s = scree::test::scene(3, 1e-3,
                                 {scree::test::body(1, 1, 1, {{0, 0, 1}}, {{0.5, 0.1, -0.3}}, {{0, 2, 1}}),
                                  scree::test::body(2, 1, 1, {{1.95, 0.2, 1.1}})},
                                 law);
    scree::test::add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
    s.integration = traits.integration;
    Simulation whole(s), observed(s);
    double time = 0;
    int substeps = 0;
    for (int k = 0; k < 50; ++k) {
      whole.step();
      observed.step([&](double length) { time += length, ++substeps; });
    }
    CHECK(observed.state_hash() == whole.state_hash());
    CHECK(time == Approx(whole.time()).epsilon(100 * epsilon));
    CHECK(substeps == 50 * (traits.integration == scree::Integration::fourth_order ? 5 : 1));
  }
}
