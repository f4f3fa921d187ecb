#include "scenes.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/scene_record.hpp>
#include <scree/simulation.hpp>
#include <scree/stage.hpp>
#include <scree/state.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double ground_step = 1e-4, ground_stiffness = 1e4, sphere_mass = 1, sphere_radius = 0.1,
                 ground_gravity = 10;
const std::string ground_law = "linear_spring_dashpot";
const Values ground_spring = {{"normal_stiffness", {ground_stiffness}}, {"normal_damping", {20}}};
constexpr double resting_height = sphere_radius - sphere_mass * ground_gravity / ground_stiffness;
// The last of the controls of a plane and of a box.
constexpr double absent_plane = 7, absent_wall = 7, fixed_plane = 0;

Parameters ground(double control) {
  return parameters("plane", SCREE_BOUNDARY,
                    {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"control", {control}}});
}

// A sphere at rest on the ground.
Scene sphere_on_ground(double control = fixed_plane) {
  Scene s =
      scene(3, ground_step, {body(1, sphere_radius, sphere_mass, {{0, 0, resting_height}})}, ground_spring);
  s.boundaries.push_back({"ground", 0, ground(control)});
  add_body_force(s, "gravity", {{"acceleration", {0, 0, -ground_gravity}}});
  return s;
}

void set_ground(Simulation& s, double control) {
  s.reconfigure_boundary("ground", ground(control));
  s.apply_reconfiguration();
}

Parameters left_out(Parameters all) {
  all.set_absent(true);
  return all;
}

}  // namespace

TEST_CASE("a wall that is absent keeps its place and bears nothing: the sphere on it falls freely") {
  Simulation s(sphere_on_ground());
  run(s, 10);
  CHECK(s.loads()[0].force[2] == Approx(-sphere_mass * ground_gravity));
  set_ground(s, absent_plane);
  CHECK(s.loads()[0].force[2] == 0);
  CHECK(s.absent_walls()[0]);
  run(s, 1000);
  // Constant acceleration is exact in velocity Verlet; 1000 roundings.
  CHECK(position(s, 0)[2] == Approx(resting_height - 0.5 * ground_gravity * 0.01).epsilon(1e-11));
  CHECK(s.planes()[0].point[2] == 0);
  // The energy of the contact, F²/2k, is taken away as work.
  CHECK(s.energy().work ==
        Approx(-0.5 * std::pow(sphere_mass * ground_gravity, 2) / ground_stiffness).epsilon(1e-9));
  CHECK(std::abs(s.energy_residual()) < 1e-12);
}

TEST_CASE("a wall that is absent from the start is passed, and holds what is above it once it is there") {
  Scene scene = sphere_on_ground(absent_plane);
  scene.bodies[0].position = {{0, 0, 0.15}};
  Simulation passing(scene);
  run(passing, 6000);  // 0.6 s: 1.8 m
  CHECK(position(passing, 0)[2] == Approx(0.15 - 0.5 * ground_gravity * 0.36).epsilon(1e-11));
  Simulation held(scene);
  run(held, 900);  // 4 cm
  set_ground(held, fixed_plane);
  run(held, 30000);
  // Bounces of 1 m/s × 0.73^n last 0.6 s; then the dashpot leaves exp(−10/s × 2 s) of 0.01 m.
  CHECK(position(held, 0)[2] == Approx(resting_height).margin(1e-4));
}

TEST_CASE("a wall does not come back before the centre of a body") {
  Simulation s(sphere_on_ground(absent_plane));
  run(s, 2000);  // 0.2 m down
  REQUIRE(position(s, 0)[2] < 0);
  try {
    set_ground(s, fixed_plane);
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::blow_up);
    CHECK_THAT(error.what(),
               Catch::Contains(
                   "wall ground is to be there again with the centre of 1 body behind it, of body 1 by"));
  }
}

TEST_CASE("a stage in which a wall would come back before the centre of a body does not begin") {
  const auto stage = [](const char* name, double control) {
    Stage s;
    s.name = name;
    s.duration = 0.2;
    s.changes = {
        {SCREE_CONTACT_LAW, ground_law, parameters(ground_law, SCREE_CONTACT_LAW, ground_spring), {}},
        {SCREE_BOUNDARY, "ground", ground(control), {}}};
    return s;
  };
  Simulation s(sphere_on_ground());
  StageRunner runner(s, {stage("open", absent_plane), stage("close", fixed_plane)});
  try {
    runner.run(3000, [] { return true; });
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::not_reached);
    CHECK_THAT(
        error.what(),
        Catch::StartsWith("stage 'close': wall ground is to be there again with the centre of 1 body"));
  }
  // All is as at the end of the stage before.
  CHECK(runner.current() == 0);
  CHECK(s.steps() == 2000);
  CHECK(s.absent_walls()[0]);
}

TEST_CASE("a wall of a box is absent alone") {
  const auto box = [](double control) {
    return parameters("box", SCREE_BOUNDARY,
                      {{"lower", {-1, -1, 0}},
                       {"upper", {1, 1, 2}},
                       {"x", {1}},
                       {"y", {1}},
                       {"z_low", {control}},
                       {"z_high", {1}}});
  };
  Scene scene = sphere_on_ground();
  scene.boundaries[0].parameters = box(1);
  Simulation s(scene);
  s.reconfigure_boundary("ground", box(absent_wall));
  s.apply_reconfiguration();
  CHECK(s.absent_walls() == std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0});
  run(s, 1000);
  CHECK(position(s, 0)[2] == Approx(resting_height - 0.5 * ground_gravity * 0.01).epsilon(1e-11));
}

TEST_CASE("bodies whose law is absent pass through each other, and push once it is there") {
  Scene scene = test::scene(3, ground_step,
                            {body(1, sphere_radius, sphere_mass, {{-0.3, 0, 0}}, {{1, 0, 0}}),
                             body(2, sphere_radius, sphere_mass, {{0.3, 0, 0}}, {{-1, 0, 0}})},
                            ground_spring);
  const Parameters present = scene.laws[0].parameters;
  scene.laws[0].parameters = left_out(present);
  Simulation s(scene);
  run(s, 6000);
  CHECK(position(s, 0)[0] == Approx(0.3).epsilon(1e-11));
  CHECK(s.energy().elastic_normal == 0);
  Simulation met(scene);
  run(met, 1000);
  met.reconfigure_law(ground_law, present);
  met.apply_reconfiguration();
  run(met, 6000);
  CHECK(velocity(met, 0)[0] < -0.5);
  CHECK(std::abs(met.energy_residual()) < 1e-4);  // step error: (ω Δt)², ω = 141/s
}

TEST_CASE("a body force that is absent exerts nothing and damps nothing") {
  Scene scene = sphere_on_ground(absent_plane);
  add_body_force(scene, "background_damping", {{"translational", {5}}});
  for (Scene::BodyForce& force : scene.body_forces) force.parameters = left_out(force.parameters);
  scene.bodies[0].velocity = {{1, 0, 0}};
  Simulation s(scene);
  run(s, 1000);
  CHECK(velocity(s, 0) == Vec3{{1, 0, 0}});
  CHECK(s.energy().dissipated_translation == 0);
  s.reconfigure_body_force("background_damping",
                           parameters("background_damping", SCREE_BODY_FORCE, {{"translational", {5}}}));
  s.apply_reconfiguration();
  run(s, 1000);
  // Order 2 in the step: (γ Δt/m)² γ t/m / 6.
  CHECK(velocity(s, 0)[0] == Approx(std::exp(-0.5)).epsilon(1e-7));
}

TEST_CASE("a state with an absent wall, law and force goes on to the same bits, and records them") {
  Scene scene = sphere_on_ground();
  scene.bodies.push_back(body(2, sphere_radius, sphere_mass, {{0, 0, 3 * sphere_radius}}));
  add_body_force(scene, "background_damping", {{"translational", {5}}});
  Simulation whole(scene);
  run(whole, 50);
  set_ground(whole, absent_plane);
  scene.boundaries[0].parameters = ground(absent_plane);
  whole.reconfigure_law(ground_law, left_out(scene.laws[0].parameters));
  scene.laws[0].parameters = left_out(scene.laws[0].parameters);
  whole.reconfigure_body_force("background_damping", left_out(scene.body_forces[1].parameters));
  const Parameters drag = scene.body_forces[1].parameters;
  scene.body_forces[1].parameters = left_out(drag);
  whole.apply_reconfiguration();
  run(whole, 50);
  const State state = whole.state();
  Simulation again(scene, state);
  run(whole, 200), run(again, 200);
  CHECK(whole.state_hash() == again.state_hash());
  Scene other = scene;
  other.body_forces[1].parameters = drag;
  CHECK(is_scene_of(state, scene));
  CHECK_FALSE(is_scene_of(state, other));
  CHECK_THROWS_AS(Simulation(other, state), Error);
}
