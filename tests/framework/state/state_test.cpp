#include "state/heap.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/scene_record.hpp>
#include <scree/state_transfer.hpp>

using scree::Body;
using scree::Integration;
using scree::Scene;
using scree::Simulation;
using scree::State;
using scree::test::check_same;
using scree::test::error_line;
using scree::test::heap;
using scree::test::steps_of_heap;

namespace {

// Goes on from the state of a simulation after some steps, and compares with the simulation that never
// stopped.
void check_resumed(Simulation& whole, Scene scene) {
  const State stopped = whole.state();
  scene.bodies = scree::bodies_at_start(stopped);
  scene.threads = 3;
  Simulation resumed(scene, stopped);
  check_same(stopped, resumed.state());
  scree::test::run(whole, steps_of_heap);
  resumed.run(steps_of_heap, [] { return true; });
  REQUIRE(whole.rebuilds() > 2);
  check_same(whole.state(), resumed.state());
  CHECK(whole.state_hash() == resumed.state_hash());
}

}  // namespace

TEST_CASE("a simulation goes on from its state to the same bits", "[threads]") {
  const int dimension = GENERATE(2, 3);
  const bool periodic = GENERATE(false, true);
  const auto integration = GENERATE(Integration::velocity_verlet, Integration::position_verlet,
                                    Integration::fourth_order, Integration::predictor_corrector);
  Scene scene = heap(dimension, periodic);
  scene.integration = integration;
  INFO(dimension << "D, periodic: " << periodic << ", integrator " << int(integration));
  Simulation whole(scene);
  scree::test::run(whole, steps_of_heap);
  REQUIRE(whole.contact_list().size() > 100);
  check_resumed(whole, scene);
}

TEST_CASE("a simulation goes on from the state at its start") {
  const Scene scene = heap(3, false);
  Simulation whole(scene);
  check_resumed(whole, scene);
}

TEST_CASE("a body that has no partner has a state too") {
  Scene scene = heap(3, false);
  scene.boundaries.clear();
  scene.bodies.resize(1);
  Simulation whole(scene);
  scree::test::run(whole, 10);
  const State state = whole.state();
  check_same(state, Simulation(scene, state).state());
}

TEST_CASE("a simulation goes on from its state within a later stage") {
  const auto integration = GENERATE(Integration::velocity_verlet, Integration::position_verlet);
  Scene scene = heap(3, false);
  scene.integration = integration;
  Simulation whole(scene);
  scree::test::run(whole, steps_of_heap);
  scene.laws[0].parameters = scree::test::parameters("linear_spring_dashpot", SCREE_CONTACT_LAW,
                                                     {{"normal_stiffness", {2e4}},
                                                      {"restitution", {0.6}},
                                                      {"tangential_stiffness", {5e3}},
                                                      {"static_friction", {0.5}},
                                                      {"tangential_damping", {1}}});
  scene.boundaries[0].parameters = scree::test::parameters(
      "box", SCREE_BOUNDARY, {{"stress", {0, 60}}, {"mass", {500}}, {"viscosity", {5}}, {"x_low", {1}}});
  whole.reconfigure_law("linear_spring_dashpot", scene.laws[0].parameters);
  whole.reconfigure_boundary("box", scene.boundaries[0].parameters);
  whole.apply_reconfiguration();
  scree::test::run(whole, steps_of_heap);
  check_resumed(whole, scene);
}

TEST_CASE("a state at the beginning of a stage is that of the simulation, which saving does not change",
          "[threads]") {
  const auto integration = GENERATE(Integration::velocity_verlet, Integration::position_verlet,
                                    Integration::fourth_order, Integration::predictor_corrector);
  Scene scene = heap(3, false);
  scene.integration = integration;
  Simulation whole(scene);
  for (int stage = 0; stage < 3; ++stage) {
    INFO("integrator " << int(integration) << ", stage " << stage);
    scree::test::run(whole, 10);
    scene.boundaries[0].parameters = scree::test::parameters(
        "box", SCREE_BOUNDARY,
        {{"stress", {0, 60.0 + stage}}, {"mass", {1000}}, {"viscosity", {10}}, {"x_low", {1}}});
    whole.reconfigure_boundary("box", scene.boundaries[0].parameters);
    whole.apply_reconfiguration();
    const std::uint64_t before = whole.state_hash();
    const State state = whole.state();
    CHECK(whole.state_hash() == before);
    CHECK(error_line([&] { Simulation(scene, state); }) == "no error");
  }
}

TEST_CASE("orientations and their rounded-off parts are in the state") {
  const int dimension = GENERATE(2, 3);
  Scene scene = heap(dimension, false);
  scene.orientations = true;
  Simulation whole(scene);
  scree::test::run(whole, steps_of_heap);
  const State state = whole.state();
  const auto& rounded = std::get<std::vector<double>>(state.at("bodies/orientation_rounded_off").values);
  REQUIRE(std::any_of(rounded.begin(), rounded.end(), [](double x) { return x != 0; }));
  check_resumed(whole, scene);
}

TEST_CASE("forces of pairs are in the state only if the scene keeps them") {
  Scene scene = heap(2, false);
  scene.pair_forces = GENERATE(false, true);
  Simulation whole(scene);
  scree::test::run(whole, steps_of_heap);
  const State state = whole.state();
  CHECK(state.has("contacts/force") == scene.pair_forces);
  const Simulation resumed(scene, state);
  const scree::ContactList before = whole.contact_list(), after = resumed.contact_list();
  CHECK(before.pair == after.pair);
  if (!scene.pair_forces) return;
  CHECK(before.force == after.force);
  CHECK(std::any_of(after.force.begin(), after.force.end(), [](double f) { return f > 0; }));
}

TEST_CASE("a scene without pairs has a state") {
  Scene scene = heap(2, true);
  scene.bodies.resize(1);
  scene.pair_forces = true;
  Simulation whole(scene);
  const State stopped = whole.state();
  scree::test::run(whole, 10);
  Simulation resumed(scene, stopped);
  scree::test::run(resumed, 10);
  check_same(whole.state(), resumed.state());
}

TEST_CASE("the bodies at the start come back from the state") {
  const Scene scene = heap(3, true);
  Simulation s(scene);
  scree::test::run(s, 10);
  const std::vector<Body> bodies = scree::bodies_at_start(s.state());
  REQUIRE(bodies.size() == scene.bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    CHECK(bodies[i].id == scene.bodies[i].id);
    CHECK(bodies[i].radius == scene.bodies[i].radius);
    CHECK(bodies[i].mass == scene.bodies[i].mass);
    CHECK(bodies[i].inertia == scene.bodies[i].inertia);
    CHECK(bodies[i].position == scene.bodies[i].position);
    CHECK(bodies[i].velocity == scene.bodies[i].velocity);
    CHECK(bodies[i].spin == scene.bodies[i].spin);
  }
}

TEST_CASE("which bodies are fixed is in the state, from which they go on to the same bits") {
  Scene scene = heap(2, false);
  scene.integration = GENERATE(Integration::velocity_verlet, Integration::predictor_corrector);
  for (std::size_t i = 0; i < 16; ++i) {
    scene.bodies[i].fixed = true;
    scene.bodies[i].velocity = scene.bodies[i].spin = {};
  }
  Simulation s(scene);
  scree::test::run(s, steps_of_heap);
  const State state = s.state();
  Scene later = scene;
  later.bodies = scree::bodies_at_start(state);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) CHECK(later.bodies[i].fixed == (i < 16));
  Simulation restored(later, state);
  CHECK(restored.state_hash() == s.state_hash());
  scree::test::run(s, steps_of_heap);
  scree::test::run(restored, steps_of_heap);
  CHECK(restored.state_hash() == s.state_hash());
  CHECK(restored.state() == s.state());
  CHECK(scree::test::position(restored, 3) == scene.bodies[3].position);
  const std::vector<Body> present = scree::present_bodies(s.state());
  CHECK(present[3].fixed);
  CHECK_FALSE(present[16].fixed);

  // A scene in which other bodies are fixed is another one.
  later.bodies[3].fixed = false;
  CHECK_THAT(error_line([&] { Simulation(later, state); }), Catch::Contains("state_hash"));
}

TEST_CASE("a state says which bodies are fixed only if some are, by one number for each") {
  Scene scene = heap(2, false);
  CHECK_FALSE(Simulation(scene).state().has("bodies/fixed"));
  scene.bodies[0].fixed = true;
  scene.bodies[0].velocity = scene.bodies[0].spin = {};
  const State state = Simulation(scene).state();
  const auto refusal = [&](const char* path, const scree::StateArray& array) {
    State damaged = state;
    damaged.put(path, array);
    return error_line([&] { scree::bodies_at_start(damaged); });
  };
  CHECK(refusal("bodies/fixed", state.at("bodies/fixed")) == "no error");
  scree::StateArray array = state.at("bodies/fixed");
  auto& numbers = std::get<std::vector<std::uint8_t>>(array.values);
  numbers[1] = 2;
  CHECK_THAT(refusal("bodies/fixed", array), Catch::Contains("'bodies/fixed' has the number 2"));
  numbers.pop_back();
  CHECK_THAT(refusal("bodies/fixed", array), Catch::Contains("bodies/fixed"));
}

TEST_CASE("a state of another scene is refused with what differs") {
  const Scene scene = heap(3, false);
  Simulation s(scene);
  scree::test::run(s, 10);
  const State state = s.state();
  const auto refusal = [&](const Scene& other) { return error_line([&] { Simulation(other, state); }); };
  REQUIRE(refusal(scene) == "no error");

  Scene other = heap(2, false);
  CHECK_THAT(refusal(other),
             Catch::Matchers::Contains("scene/dimension") && Catch::Matchers::Contains("'3' there"));
  other = scene;
  other.laws[0].parameters =
      scree::test::parameters("linear_spring_dashpot", SCREE_CONTACT_LAW, {{"normal_stiffness", {2e4}}});
  CHECK_THAT(refusal(other), Catch::Matchers::Contains("normal_stiffness = 10000"));
  other.laws[0].parameters = scree::test::parameters("hertz_mindlin", SCREE_CONTACT_LAW,
                                                     {{"youngs_modulus", {1e7}}, {"poissons_ratio", {0.3}}});
  CHECK_THAT(refusal(other), Catch::Matchers::Contains("hertz_mindlin"));
  other = scene;
  other.materials[0] = "sand";
  CHECK_THAT(refusal(other), Catch::Matchers::Contains("sand"));
  other = scene;
  other.boundaries.clear();
  CHECK_THAT(refusal(other), Catch::Matchers::Contains("boundary"));
  other = scene;
  other.integration = Integration::fourth_order;
  CHECK_THAT(refusal(other), Catch::Matchers::Contains("fourth_order"));
  other = scene;
  other.bodies.pop_back();
  CHECK_THAT(refusal(other), Catch::Matchers::Contains(" instead of "));
}

TEST_CASE("a state without one of its arrays, or with one of another size or type, is refused by its name") {
  Scene scene = heap(2, false);
  Simulation s(scene);
  scree::test::run(s, steps_of_heap);
  const State state = s.state();
  const auto restore = [&](const State& damaged) {
    return error_line([&] {
      Scene present = scene;
      present.bodies = scree::bodies_at_start(damaged);
      Simulation(present, damaged);
    });
  };
  REQUIRE(restore(state) == "no error");
  for (const auto& [path, array] : state.arrays()) {
    INFO(path);
    State cut, longer = state, other_type = state;
    for (const auto& [name, numbers] : state.arrays())
      if (name != path) cut.put(name, numbers);
    // Absent velocities at the start stand for 0, from which other limits follow than in the scene.
    if (!path.starts_with("start/velocity") && !path.starts_with("start/spin"))
      CHECK_THAT(restore(cut), Catch::Matchers::Contains(path));
    scree::StateArray more = array;
    std::visit([](auto& numbers) { numbers.emplace_back(); }, more.values);
    longer.put(path, more);
    CHECK(restore(longer) != "no error");
    other_type.put(path, {std::vector<float>(array.size()), array.shape, array.unit});
    CHECK(restore(other_type) != "no error");
  }
}

TEST_CASE("a state with pairs of bodies that do not exist is refused") {
  Scene scene = heap(2, false);
  Simulation s(scene);
  scree::test::run(s, steps_of_heap);
  const State state = s.state();
  const char* const path =
      GENERATE("contacts/0/b", "contacts/0/history_row", "contacts/0/a", "contacts/force_row");
  scree::StateArray pairs = state.at(path);
  auto& numbers = std::get<std::vector<std::uint32_t>>(pairs.values);
  REQUIRE(!numbers.empty());
  numbers.back() = 1u << 31;
  State damaged = state;
  damaged.put(path, pairs);
  CHECK_THAT(error_line([&] { Simulation(scene, damaged); }), Catch::Matchers::Contains("'contacts/"));
}

TEST_CASE("a changed number in a state is noticed") {
  Scene scene = heap(2, false);
  Simulation s(scene);
  scree::test::run(s, steps_of_heap);
  State state = s.state();
  const char* const path =
      GENERATE("bodies/position", "bodies/velocity", "contacts/0/history", "walls/planes/point");
  scree::StateArray numbers = state.at(path);
  std::get<std::vector<double>>(numbers.values).at(0) += 1e-9;
  state.put(path, numbers);
  CHECK_THAT(error_line([&] { Simulation(scene, state); }), Catch::Matchers::Contains("state_hash"));
}

TEST_CASE("numbers of a state with which a simulation cannot go on are refused by their names") {
  Scene scene = heap(2, false);
  scene.integration = Integration::predictor_corrector;
  Simulation s(scene);
  scree::test::run(s, steps_of_heap);
  const State state = s.state();
  const auto with_number = [&](const std::string& path, double number) {
    State damaged = state;
    scree::StateArray array = state.at(path);
    std::get<std::vector<double>>(array.values).at(0) = number;
    damaged.put(path, array);
    return error_line([&] {
      Scene present = scene;
      present.bodies = scree::bodies_at_start(damaged);
      scree::present_bodies(damaged);
      Simulation(present, damaged);
    });
  };
  const double nan = std::nan("");
  for (const char* const path : {"bodies/radius", "bodies/mass", "bodies/inertia"}) {
    INFO(path);
    for (const double number : {0.0, -1.0, nan})
      CHECK_THAT(with_number(path, number), Catch::Matchers::Contains(std::string("'") + path + "' has "));
  }
  for (const double skin : {0.0, -1.0, nan, double(INFINITY)})
    CHECK_THAT(with_number("neighbours/skin", skin), Catch::Matchers::Contains("which is not above 0"));
  CHECK_THAT(with_number("start/position", nan), Catch::Matchers::Contains("not finite"));
  CHECK_THAT(with_number("bodies/velocity", nan), Catch::Matchers::Contains("not finite"));
  CHECK_THAT(with_number("clock/force_time", nan), Catch::Matchers::Contains("not finite"));

  State other_material = state;
  scree::StateArray material = state.at("bodies/material");
  std::get<std::vector<std::uint32_t>>(material.values).at(0) = 1u << 31;
  other_material.put("bodies/material", material);
  CHECK_THAT(error_line([&] { scree::present_bodies(other_material); }),
             Catch::Matchers::Contains("'bodies/material'"));
}
