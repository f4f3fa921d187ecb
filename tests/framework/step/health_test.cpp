#include "error_line.hpp"
#include "numbers.hpp"
#include "scenes.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

using scree::Body;
using scree::Scene;
using scree::Simulation;
using scree::test::error_line;
using scree::test::infinite;
using scree::test::not_a_number;

namespace {

Scene scene_of_bodies(const std::vector<Body>& bodies, double step = 1e-3, double stiffness = 1e4) {
  return scree::test::scene(3, step, bodies, {{"normal_stiffness", {stiffness}}, {"normal_damping", {0}}});
}

std::vector<Body> three_apart() {
  std::vector<Body> bodies;
  for (int i = 0; i < 3; ++i) bodies.push_back(scree::test::body(100 + i, 1, 1, {{3.0 * i, 0, 0}}));
  return bodies;
}

std::string blow_up(const std::function<void()>& call) {
  return error_line(call, scree::ExitStatus::blow_up);
}

}  // namespace

TEST_CASE("a velocity that is not finite stops the run at once, with body, time and remedy") {
  for (const double bad : {not_a_number, infinite, -infinite})
    for (int axis = 0; axis < 3; ++axis) {
      Simulation s(scene_of_bodies(three_apart()));
      scree::test::run(s, 4);
      // The simulation itself is not const; only its accessor is.
      const_cast<scree::Particles&>(s.particles()).velocity()[axis][1] = bad;
      CHECK_THAT(blow_up([&] { s.step(); }),
                 Catch::StartsWith("particle 101: position, velocity or spin is not a number") &&
                     Catch::Contains("at t = 0.00") &&
                     Catch::Contains("use a shorter time.step (now 0.001 s)"));
    }
}

TEST_CASE("a spin that is not finite stops a run that carries orientations, with body and time") {
  for (const double bad : {not_a_number, infinite, -infinite})
    for (const auto integration :
         {scree::Integration::velocity_verlet, scree::Integration::position_verlet,
          scree::Integration::fourth_order, scree::Integration::predictor_corrector}) {
      Scene scene = scene_of_bodies(three_apart());
      scene.spin = scene.orientations = true;
      scene.integration = integration;
      Simulation s(scene);
      scree::test::run(s, 4);
      const_cast<scree::Particles&>(s.particles()).spin()[1][1] = bad;
      CHECK_THAT(blow_up([&] { s.step(); }),
                 Catch::StartsWith("particle 101: position, velocity or spin is not a number") &&
                     Catch::Contains("at t = 0.00"));
    }
}

TEST_CASE("an invalid scene is refused with the name of the fault") {
  const auto refused = [](const std::function<void(Scene&)>& spoil) {
    Scene scene = scene_of_bodies(three_apart());
    scree::test::add_boundary(scene, "plane", {{"point", {0, 0, -2}}, {"normal", {0, 0, 1}}}, "floor");
    spoil(scene);
    return error_line([&] { Simulation s(scene); }, scree::ExitStatus::bad_input);
  };
  CHECK(refused([](Scene&) {}) == "no error");
  for (const double bad : {not_a_number, infinite, -infinite}) {
    CHECK_THAT(refused([&](Scene& s) { s.bodies[2].position[1] = bad; }),
               Catch::StartsWith("particle 102: position"));
    CHECK_THAT(refused([&](Scene& s) { s.bodies[1].velocity[0] = bad; }),
               Catch::StartsWith("particle 101: position"));
    CHECK_THAT(refused([&](Scene& s) { s.bodies[0].spin[2] = bad; }),
               Catch::StartsWith("particle 100: position"));
  }
  for (const double bad : {not_a_number, infinite, 0.0, -1.0}) {
    CHECK_THAT(refused([&](Scene& s) { s.bodies[2].radius = bad; }),
               Catch::StartsWith("particle 102: radius"));
    CHECK_THAT(refused([&](Scene& s) { s.bodies[2].mass = bad; }), Catch::StartsWith("particle 102: radius"));
  }
  for (const double bad : {not_a_number, 0.0, -1e-3})
    CHECK_THAT(refused([&](Scene& s) { s.step = bad; }), Catch::Contains("time step"));
  CHECK_THAT(refused([](Scene& s) { s.bodies[1].material = 1; }),
             Catch::StartsWith("particle 101: material 1 of 1"));
  CHECK_THAT(refused([](Scene& s) { s.boundaries[0].material = 1; }),
             Catch::StartsWith("boundary 'floor': material"));
  CHECK_THAT(refused([](Scene& s) { s.law_of = {1}; }), Catch::Contains("law 1 of 1"));
  CHECK_THAT(refused([](Scene& s) { s.materials.push_back("other"); }),
             Catch::StartsWith("law_of has 1 entry instead of 4 for 2 materials; "));
}

TEST_CASE("a spin that is not finite stops the run") {
  Scene scene = scree::test::scene(2, 1e-3,
                                   {scree::test::body(8, 1, 1, {{0, 0.99, 0}}, {}, {{0, 0, 1}}, 2),
                                    scree::test::body(9, 1, 1, {{9, 0.99, 0}}, {}, {{0, 0, 1}}, 2)},
                                   {{"normal_stiffness", {1e3}},
                                    {"normal_damping", {0}},
                                    {"tangential_stiffness", {1e3}},
                                    {"static_friction", {0.5}}});
  scree::test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  Simulation s(scene);
  const_cast<scree::Particles&>(s.particles()).spin()[2][1] = not_a_number;
  CHECK_THAT(blow_up([&] { scree::test::run(s, 2); }),
             Catch::StartsWith("particle 9: position, velocity or spin"));
}

TEST_CASE("a body faster than the limit stops the run") {
  Scene scene = scene_of_bodies(three_apart());
  scene.bodies[2].velocity = {{0, 30, 40}};  // 50 m/s
  scene.limits.speed = 51;
  {
    Simulation s(scene);
    CHECK_NOTHROW(scree::test::run(s, 10));
  }
  scene.limits.speed = 49;
  CHECK_THAT(blow_up([&] {
               Simulation s(scene);
               scree::test::run(s, 1);
             }),
             Catch::StartsWith("particle 102 moves at 50 m/s") &&
                 Catch::Contains("above the limit of 49 m/s") && Catch::Contains("raise limits.speed"));
}

TEST_CASE("by default a body may not move by the smallest radius in a step") {
  Scene scene = scene_of_bodies(three_apart());
  // Speeds are relative to the walls; without walls, to the mean velocity.
  scree::test::add_boundary(scene, "plane", {{"point", {0, 0, -1e6}}, {"normal", {0, 0, 1}}});
  scene.bodies[0].radius = 0.25;  // 250 m/s
  scene.bodies[2].velocity = {{0, 249, 0}};
  {
    Simulation s(scene);
    CHECK_NOTHROW(scree::test::run(s, 5));
  }
  scene.bodies[2].velocity = {{0, 251, 0}};
  CHECK_THAT(blow_up([&] {
               Simulation s(scene);
               scree::test::run(s, 1);
             }),
             Catch::Contains("limit of 250 m/s"));
}

TEST_CASE("an overlap beyond the bound stops the run and names both partners") {
  // Speed v turns into an overlap of v √(m*/k) = 0.4 at first maximum; the smaller radius is 0.5.
  std::vector<Body> bodies = {scree::test::body(11, 1, 2, {{0, 0, 0}}, {{4, 0, 0}}),
                              scree::test::body(12, 0.5, 2, {{1.6, 0, 0}}),
                              scree::test::body(13, 1, 1, {{0, 8, 0}})};
  Scene scene = scene_of_bodies(bodies, 1e-3, 100);
  scene.limits.overlap_ratio = 0.81;
  {
    Simulation s(scene);
    scree::test::run(s, 400);
    CHECK(s.max_overlap_ratio() == Approx(0.8).epsilon(0.01));  // (ωh)² ~ 1e-4, and the sampling of the crest
  }
  scene.limits.overlap_ratio = 0.5;
  CHECK_THAT(blow_up([&] {
               Simulation s(scene);
               scree::test::run(s, 400);
             }),
             Catch::StartsWith("contact of particle 11 with particle 12: overlap is 0.5") &&
                 Catch::Contains("of the smaller radius at t = ") &&
                 Catch::Contains("above the limit of 0.5") && Catch::Contains("raise limits.overlap_ratio"));
}

TEST_CASE("overlaps are checked from the start, walls included") {
  Scene scene = scene_of_bodies({scree::test::body(5, 1, 1, {{0, 0, 0.25}})});
  scree::test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}}, "floor");
  CHECK_THAT(blow_up([&] { Simulation s(scene); }),
             Catch::StartsWith(
                 "contact of particle 5 with wall floor: overlap is 0.75 of the smaller radius at t = 0 s"));
  scene.limits.overlap_ratio = 0.76;
  CHECK_NOTHROW(Simulation(scene));
}

TEST_CASE("a far too long step is reported and gives no results") {
  // ω h = √(k/m*) h = 4.5: velocity Verlet is unstable above 2.
  Scene scene = scene_of_bodies(
      {scree::test::body(1, 1, 1, {{0, 0, 0}}), scree::test::body(2, 1, 1, {{1.9, 0, 0}})}, 0.032, 1e4);
  scree::test::add_boundary(scene, "box",
                            {{"lower", {-1.1, -9, -9}},
                             {"upper", {3, 9, 9}},
                             {"x_low", {1}},
                             {"x_high", {1}},
                             {"y_low", {1}},
                             {"y_high", {1}},
                             {"z_low", {1}},
                             {"z_high", {1}}});
  Simulation s(scene);
  CHECK(s.min_steps_per_contact() < 1);  // t_c = π/ω
  CHECK_THAT(blow_up([&] { scree::test::run(s, 1000); }), Catch::Contains("time.step"));
}

TEST_CASE("a wall that diverges is reported too") {
  Scene scene = scene_of_bodies({scree::test::body(1, 1, 1, {{0, 0, 0}})});
  // Only its own mass, which is tiny, limits its motion.
  scree::test::add_boundary(scene, "box", {{"gap", {1}}, {"stress", {0, 1e10}}, {"mass", {1e-305}}});
  Simulation s(scene);
  CHECK_THAT(blow_up([&] { scree::test::run(s, 100); }), Catch::Contains("wall box."));
}

TEST_CASE("a wall that slides along itself infinitely fast is reported, although its normal speed is NaN") {
  Scene scene = scene_of_bodies({scree::test::body(1, 1, 1, {{0, 0, 5}})});
  scree::test::add_boundary(scene, "plane",
                            {{"point", {0, 0, 0}},
                             {"normal", {0, 0, 1}},
                             {"direction", {1, 0, 0}},
                             {"displacement", {4, 0, 0, 0.001, 0, 0.002, 1e308}}});
  Simulation s(scene);
  CHECK_THAT(blow_up([&] { scree::test::run(s, 3); }),
             Catch::StartsWith("boundary plug-in plane, wall plane: position is (") &&
                 Catch::Contains("at t = 0.00"));
}

TEST_CASE("an exception of a law in a step is reported with the plug-ins of the scene", "[health]") {
  scree::PluginHost laws({SCREE_TEST_LAWS});
  scree::Parameters law(laws.find("throwing", SCREE_CONTACT_LAW));
  const auto scene_with_limit = [&](double limit) {
    law.set("limit", {limit});
    scree::Scene s;
    s.step = 1e-3;
    s.materials = {"grain"};
    s.bodies = {scree::test::body(1, 1, 1, {}, {}), scree::test::body(2, 1, 1, {{1.9, 0, 0}}, {{-1, 0, 0}})};
    s.laws = {{"law", law}};
    s.law_of = {0};
    return s;
  };
  CHECK_THROWS_WITH(scree::Simulation(scene_with_limit(0.01)),
                    Catch::StartsWith("one of the plug-ins throwing threw an exception (boo) in step 1, "));
  scree::Simulation s(scene_with_limit(0.105));
  CHECK_THROWS_WITH(
      scree::test::run(s, 20),
      Catch::StartsWith("one of the plug-ins throwing threw an exception (boo) in step 6, at t = "));
}
