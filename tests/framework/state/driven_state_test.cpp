#include "motion/driven.hpp"
#include "state/heap.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/branching.hpp>
#include <scree/plugin/program.hpp>
#include <scree/scene_record.hpp>

using scree::Body;
using scree::BodyGroup;
using scree::Integration;
using scree::Program;
using scree::Scene;
using scree::Simulation;
using scree::State;
using scree::test::bit;
using scree::test::check_same;
using scree::test::error_line;
using scree::test::group_of;
using scree::test::heap;
using scree::test::integrators;

namespace freedom = scree::freedom;

namespace {

// A heap with bodies that are shaken, held in part, fixed and moving at a constant velocity, and loaded.
Scene driven_heap(int dimension, Integration integration) {
  Scene scene = heap(dimension, false);
  scene.integration = integration;
  BodyGroup shaken = group_of("shaken", {}), loaded = group_of("loaded", {}), lifted = group_of("lifted", {});
  for (std::uint32_t i = 0; i < 16; ++i) {
    Body& body = scene.bodies[i];
    body.velocity = body.spin = {};
    body.fixed = true;
    if (i < 8) shaken.bodies.push_back(i);
    if (i >= 12) body.velocity[0] = 0.3;
    scene.bodies[i + 40].held = bit(0) | freedom::rotations;
    scene.bodies[i + 40].velocity[0] = 0.1;
    scene.bodies[i + 60].held = bit(1);
    scene.bodies[i + 60].velocity[1] = 0;
    lifted.bodies.push_back(i + 60);
    loaded.bodies.push_back(i + 130);
  }
  if (dimension == 2)
    for (Body& body : scene.bodies) body.held &= freedom::of_dimension(2);
  shaken.velocity[0] = {Program::sine, 0, 2, 20, 1};
  shaken.velocity[5] = {Program::sine, 0, 1, 30, 0};
  lifted.displacement[1] = {Program::ramp, 0, 0.05, 0.1};
  loaded.load[0] = {Program::sine, 0, 50, 15, 0.5};
  loaded.load[5] = {Program::constant, 3};
  scene.groups = {shaken, lifted, loaded};
  return scene;
}

}  // namespace

TEST_CASE("driven bodies go on from a state to the same bits, observed or not, with any number of threads",
          "[driven][threads]") {
  const int dimension = GENERATE(2, 3);
  for (const Integration integration : integrators) {
    INFO(dimension << "D, integrator " << int(integration));
    Scene scene = driven_heap(dimension, integration);
    Simulation whole(scene);
    scree::test::run(whole, 60);
    const State stopped = whole.state();
    scene.bodies = scree::bodies_at_start(stopped);
    const std::vector<BodyGroup> groups = scree::groups_of(stopped);
    REQUIRE(groups.size() == scene.groups.size());
    scene.groups = groups;
    scene.threads = 3;
    Simulation resumed(scene, stopped);
    check_same(stopped, resumed.state());
    scree::test::run(whole, 60);
    resumed.run(60, [] { return true; });
    check_same(whole.state(), resumed.state());
    CHECK(whole.energy().work != 0);
    CHECK(whole.energy_residual() < 0.02);
    CHECK(whole.momentum_residual() < 1e-13);  // round-off: what holds bodies is no contact
    // Another scene begins from the state: nothing differs but the clock, from which the functions begin
    // anew.
    scene.bodies = scree::present_bodies(stopped);
    Simulation branch(scene, stopped, scree::Branching());
    CHECK(branch.particles().velocity()[0][0] == 2 * std::sin(1.0));
    CHECK(branch.particles().velocity()[0][12] == 0.3);
    CHECK(branch.energy().work == 0);
    branch.run(60, [] { return true; });
    CHECK(branch.energy_residual() < 0.02);
  }
}

TEST_CASE("a state has what groups do only if they do something", "[driven]") {
  const State plain = Simulation(heap(2, false)).state(),
              driven = Simulation(driven_heap(2, Integration::velocity_verlet)).state();
  for (const char* path : {"bodies/held", "scene/group_names", "scene/group_0_velocity_0"}) {
    CHECK_FALSE(plain.has(path));
    CHECK(driven.has(path));
  }
  CHECK(scree::groups_of(plain).empty());
  Scene scene = driven_heap(2, Integration::velocity_verlet), other = scene;
  CHECK(scree::is_scene_of(driven, scene));
  other.groups.pop_back();
  CHECK_FALSE(scree::is_scene_of(driven, other));
  CHECK_THAT(error_line([&] { Simulation(other, driven); }), Catch::Contains("group"));
  other = scene;
  other.groups[2].load[0][2] = 51;
  CHECK_THAT(error_line([&] { Simulation(other, driven); }), Catch::Contains("scene/group_2_load_0"));
  other = scene;
  other.groups[2].load[0].clear();
  CHECK_THAT(error_line([&] { Simulation(other, driven); }), Catch::Contains("group"));
  other = scene;
  other.bodies[40].held = bit(0);
  CHECK(Simulation(other).state_hash() != Simulation(scene).state_hash());
  // 256 discs with 3 freedoms: 16 fixed, 16 without x and rotation, 16 without y.
  CHECK(Simulation(scene).footprint().degrees_of_freedom == 240 * 3 - 32 - 16);
  CHECK(Simulation(scene).footprint().held_bodies == 32);
}

TEST_CASE("groups that a simulation cannot have are refused", "[driven]") {
  const Scene scene = driven_heap(2, Integration::velocity_verlet);
  const auto refused = [&](const auto& change) {
    Scene other = scene;
    change(other);
    return error_line([&] { Simulation{other}; });
  };
  CHECK_THAT(refused([](Scene& s) { s.groups[0].bodies[0] = 300; }),
             Catch::Contains("a body that does not exist"));
  CHECK_THAT(refused([](Scene& s) { s.bodies[0].fixed = false; }),
             Catch::Contains("which is not held there; hold it"));
  CHECK_THAT(refused([](Scene& s) {
               s.groups[0].velocity[0] = {Program::sine, 0};
             }),
             Catch::Contains("not a program"));
  CHECK_THAT(refused([](Scene& s) {
               s.groups[0].displacement[0] = {Program::constant, 0};
             }),
             Catch::Contains("has a velocity and a displacement"));
  CHECK_THAT(refused([](Scene& s) { s.groups.push_back(s.groups[0]); }),
             Catch::Contains("as another group does"));
}
