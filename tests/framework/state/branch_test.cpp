#include "state/heap.hpp"

#include <catch2/catch.hpp>

#include <scree/branching.hpp>
#include <scree/state_transfer.hpp>

using scree::Branching;
using scree::Integration;
using scree::Scene;
using scree::Simulation;
using scree::State;
using scree::test::heap;
using scree::test::message_of;

namespace {

constexpr int steps = 90;

// The scene that begins where the state of another is.
Scene scene_from(const State& state, Scene scene) {
  scene.bodies = scree::present_bodies(state);
  return scene;
}

// Compares all that moves.
void check_same_motion(const Simulation& a, const Simulation& b) {
  const State before = a.state(), after = b.state();
  for (const auto& [path, array] : before.arrays())
    if ((path.starts_with("bodies/") || path.starts_with("contacts/") || path.starts_with("walls/planes")) &&
        path != "contacts/max_overlap_ratio") {
      INFO(path);
      REQUIRE(after.has(path));
      CHECK(after.at(path) == array);
    }
}

scree::test::Values law(double friction) {
  return {{"normal_stiffness", {1e4}},
          {"restitution", {0.8}},
          {"tangential_stiffness", {3e3}},
          {"tangential_damping", {1}},
          {"static_friction", {friction}}};
}

}  // namespace

TEST_CASE("a scene that begins from a state and changes nothing moves to the same bits") {
  const int dimension = GENERATE(2, 3);
  const bool periodic = GENERATE(false, true);
  const auto integration = GENERATE(Integration::velocity_verlet, Integration::position_verlet,
                                    Integration::fourth_order, Integration::predictor_corrector);
  Scene scene = heap(dimension, periodic);
  scene.integration = integration;
  Simulation first(scene);
  scree::test::run(first, steps);
  const State state = first.state();
  Simulation branch(scene_from(state, scene), state, Branching());
  CHECK(branch.time() == 0);
  CHECK(branch.steps() == 0);
  CHECK(branch.energy().dissipated_friction == 0);
  CHECK(branch.energy().work == 0);
  CHECK(branch.taken_over().size() == 2);
  check_same_motion(first, branch);
  scree::test::run(first, steps);
  scree::test::run(branch, steps);
  check_same_motion(first, branch);
  CHECK(branch.energy_residual() < 1e-2);
}

TEST_CASE("a scene that begins from a state and changes a law moves as after a stage that does") {
  Scene scene = heap(3, false);
  Simulation first(scene);
  scree::test::run(first, steps);
  const State state = first.state();
  Scene changed = scene_from(state, scene);
  changed.laws[0].parameters = scree::test::parameters("linear_spring_dashpot", SCREE_CONTACT_LAW, law(0.6));
  changed.boundaries[0].parameters = scree::test::parameters(
      "box", SCREE_BOUNDARY, {{"stress", {0, 60}}, {"mass", {1000}}, {"viscosity", {10}}, {"x_low", {1}}});
  Simulation branch(changed, state, Branching());
  first.reconfigure_law("linear_spring_dashpot", changed.laws[0].parameters);
  first.reconfigure_boundary("box", changed.boundaries[0].parameters);
  first.apply_reconfiguration();
  // The skin differs, so that lists of pairs do, but nothing that moves.
  const auto check = [&] {
    for (const char* path :
         {"bodies/position", "bodies/velocity", "bodies/spin", "bodies/force", "bodies/torque",
          "walls/planes/point", "walls/planes/velocity", "contacts/0/history"}) {
      INFO(path);
      CHECK(branch.state().at(path) == first.state().at(path));
    }
  };
  check();
  scree::test::run(first, steps);
  scree::test::run(branch, steps);
  check();
}

TEST_CASE("histories are taken over by plug-in, and walls by name") {
  Scene scene = heap(2, false);
  Simulation first(scene);
  scree::test::run(first, steps);
  const State state = first.state();
  Scene other = scene_from(state, scene);
  const auto refusal = [&](const Branching& branching = {}) {
    return message_of([&] { Simulation(other, state, branching); });
  };
  SECTION("another law") {
    other.laws[0] = {"hertz", scree::test::parameters("hertz_mindlin", SCREE_CONTACT_LAW,
                                                      {{"youngs_modulus", {1e5}},
                                                       {"poissons_ratio", {0.3}},
                                                       {"restitution", {0.8}},
                                                       {"friction", {0.3}}})};
    CHECK_THAT(refusal(), Catch::Matchers::Contains("leave_out = [\"histories\"]"));
    CHECK(refusal({.histories = false}).empty());
  }
  SECTION("a boundary of another name") {
    other.boundaries[0].name = "cage";
    CHECK_THAT(refusal(),
               Catch::Matchers::Contains("'box'") && Catch::Matchers::Contains("leave_out = [\"walls\"]"));
    CHECK(refusal({.walls = false}).empty());
  }
  SECTION("a law of another name, but the same plug-in") {
    other.laws[0].name = "grains";
    CHECK(refusal().empty());
    const Simulation branch(other, state, Branching());
    first.apply_reconfiguration();
    CHECK(branch.state().at("contacts/0/history") == first.state().at("contacts/0/history"));
  }
  SECTION("other bodies") {
    std::swap(other.bodies[0], other.bodies[1]);
    CHECK_THAT(refusal(), Catch::Matchers::Contains("not those of the state"));
  }
  SECTION("another dimension") {
    other = heap(3, false);
    CHECK_THAT(refusal(), Catch::Matchers::Contains("dimensions"));
  }
}

TEST_CASE("bodies of a state keep the velocities that the scene gives them") {
  Scene scene = heap(2, false);
  Simulation first(scene);
  scree::test::run(first, steps);
  const State state = first.state();
  Scene faster = scene_from(state, scene);
  for (scree::Body& body : faster.bodies) body.velocity[0] += 0.5;
  const Simulation branch(faster, state, Branching());
  for (std::size_t i = 0; i < faster.bodies.size(); ++i)
    CHECK(branch.particles().velocity()[0][i] == faster.bodies[i].velocity[0]);
}

TEST_CASE("a scene may add a body to those of a state") {
  Scene scene = heap(3, true);
  scene.orientations = true;
  Simulation first(scene);
  scree::test::run(first, steps);
  const State state = first.state();
  Scene more = scene_from(state, scene);
  more.bodies.push_back(scree::test::body(5000, 1, 1, {{5, 5, 60}}));
  Simulation branch(more, state, Branching());
  CHECK(branch.contact_list().size() == first.contact_list().size());
  for (const std::size_t i : {std::size_t(0), state.at("bodies/id").size() - 1})
    CHECK(branch.particles().orientations[0][i] == first.particles().orientations[0][i]);
  CHECK(branch.particles().orientations[0][more.bodies.size() - 1] == 1);
  scree::test::run(branch, 10);
}

TEST_CASE("a state whose arrays do not fit each other begins no scene") {
  Scene scene = heap(2, false);
  scene.integration = Integration::predictor_corrector;
  Simulation first(scene);
  scree::test::run(first, steps);
  const State state = first.state();
  // With ten times as many values, or with none.
  const bool longer = GENERATE(false, true);
  const char* const path = GENERATE("bodies/position", "bodies/velocity", "scene/boundary_plugins",
                                    "integrator/third", "integrator/fourth");
  INFO(path << (longer ? " ten times" : " without values"));
  State damaged = state;
  scree::StateArray array = state.at(path);
  std::visit([&](auto& values) { values.resize(longer ? 10 * values.size() : 0); }, array.values);
  array.shape = {array.size()};
  damaged.put(path, array);
  CHECK_THAT(message_of([&] { Simulation(scene_from(damaged, scene), damaged, Branching()); }),
             Catch::Matchers::Contains(path));
}
