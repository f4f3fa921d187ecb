#include "state/heap.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/branching.hpp>
#include <scree/state_transfer.hpp>

using scree::Branching;
using scree::Integration;
using scree::Scene;
using scree::Simulation;
using scree::State;
using scree::test::error_line;
using scree::test::heap;
using scree::test::steps_of_heap;

namespace {

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

scree::test::Values frictional_law(double friction) {
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
  scree::test::run(first, steps_of_heap);
  const State state = first.state();
  Simulation branch(scene_from(state, scene), state, Branching());
  CHECK(branch.time() == 0);
  CHECK(branch.steps() == 0);
  CHECK(branch.energy().dissipated_friction == 0);
  CHECK(branch.energy().work == 0);
  CHECK(branch.taken_over().size() == 2);
  check_same_motion(first, branch);
  scree::test::run(first, steps_of_heap);
  scree::test::run(branch, steps_of_heap);
  check_same_motion(first, branch);
  CHECK(branch.energy_residual() < 1e-2);
}

TEST_CASE(
    "functions of time of body forces begin anew in a scene that begins from a state, with the balance") {
  Scene scene = heap(3, false);
  scene.body_forces.push_back(
      {"pull", scree::test::parameters("gravity", SCREE_BODY_FORCE,
                                       {{"acceleration", {0, 0, 0}}, {"acceleration_x", {3, 0, 50, 0.1}}})});
  Simulation first(scene);
  scree::test::run(first, steps_of_heap);
  const State state = first.state();
  Simulation branch(scene_from(state, scene), state, Branching());
  // The force at the start is that of g(0) = 0.
  const Scene without = [&] {
    Scene s = scene_from(state, scene);
    s.body_forces.pop_back();
    return s;
  }();
  const Simulation still(without, state, Branching());
  for (std::size_t i = 0; i < without.bodies.size(); ++i)
    CHECK(branch.particles().force()[0][i] == still.particles().force()[0][i]);
  scree::test::run(branch, steps_of_heap);
  CHECK(branch.energy_residual() < 1e-2);
}

TEST_CASE("a scene that begins from a state and changes a law moves as after a stage that does") {
  Scene scene = heap(3, false);
  Simulation first(scene);
  scree::test::run(first, steps_of_heap);
  const State state = first.state();
  Scene changed = scene_from(state, scene);
  changed.laws[0].parameters =
      scree::test::parameters("linear_spring_dashpot", SCREE_CONTACT_LAW, frictional_law(0.6));
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
  scree::test::run(first, steps_of_heap);
  scree::test::run(branch, steps_of_heap);
  check();
}

TEST_CASE("histories are taken over by plug-in, and walls by name") {
  Scene scene = heap(2, false);
  Simulation first(scene);
  scree::test::run(first, steps_of_heap);
  const State state = first.state();
  Scene other = scene_from(state, scene);
  const auto refusal = [&](const Branching& branching = {}) {
    return error_line([&] { Simulation(other, state, branching); });
  };
  SECTION("another law") {
    other.laws[0] = {"hertz", scree::test::parameters("hertz_mindlin", SCREE_CONTACT_LAW,
                                                      {{"youngs_modulus", {1e5}},
                                                       {"poissons_ratio", {0.3}},
                                                       {"restitution", {0.8}},
                                                       {"friction", {0.3}}})};
    CHECK_THAT(refusal(), Catch::Matchers::Contains("leave_out = [\"histories\"]"));
    CHECK(refusal({.histories = false}) == "no error");
  }
  SECTION("a boundary of another name") {
    other.boundaries[0].name = "cage";
    CHECK_THAT(refusal(),
               Catch::Matchers::Contains("'box'") && Catch::Matchers::Contains("leave_out = [\"walls\"]"));
    CHECK(refusal({.walls = false}) == "no error");
  }
  SECTION("a law of another name, but the same plug-in") {
    other.laws[0].name = "grains";
    CHECK(refusal() == "no error");
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

// Earlier versions could evaluate contacts in single precision, with histories of float.
TEST_CASE("a state of mixed precision is not resumed, but a scene may begin from it with its springs") {
  const Scene scene = heap(3, false);
  Simulation first(scene);
  scree::test::run(first, steps_of_heap);
  State state = first.state();
  bool mixed = true;
  scree::StateTransfer::saving_to(state).value("scene/mixed_precision", "", mixed);
  const Simulation exact(scene_from(state, scene), state, Branching());
  const scree::StateArray history = state.at("contacts/0/history");
  const auto& numbers = std::get<std::vector<double>>(history.values);
  state.put("contacts/0/history",
            {std::vector<float>(numbers.begin(), numbers.end()), history.shape, history.unit});
  CHECK(error_line([&] { Simulation(scene, state); }) ==
        "the state is of a run in mixed precision, which has been removed; begin a new run from it "
        "(particles.state)");
  const Simulation branch(scene_from(state, scene), state, Branching());
  REQUIRE(exact.energy().elastic_tangential > 0);
  CHECK(branch.energy().elastic_tangential != exact.energy().elastic_tangential);
  // Rounding to float changes a spring by 2^-24 of it at most, its energy by twice as much.
  CHECK(branch.energy().elastic_tangential == Approx(exact.energy().elastic_tangential).epsilon(2e-7));
  CHECK(branch.let_go().empty());
}

TEST_CASE("bodies of a state keep the velocities that the scene gives them") {
  Scene scene = heap(2, false);
  Simulation first(scene);
  scree::test::run(first, steps_of_heap);
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
  scree::test::run(first, steps_of_heap);
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
  scree::test::run(first, steps_of_heap);
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
  CHECK_THAT(error_line([&] { Simulation(scene_from(damaged, scene), damaged, Branching()); }),
             Catch::Matchers::Contains(path));
}

namespace {

// A heap whose contacts have stretched springs, its state, and a scene that begins from it.
struct Stretched {
  Scene scene = heap(3, false);
  Simulation first = Simulation(scene);
  State state = (scree::test::run(first, steps_of_heap), first.state());
  scree_energy before = first.energy();
  Scene next = scene_from(state, scene);

  void set_law(double friction) {
    next.laws[0].parameters =
        scree::test::parameters("linear_spring_dashpot", SCREE_CONTACT_LAW, frictional_law(friction));
  }
};

// The balance is closed to round-off at t = 0.
void check_closed(const Simulation& branch) {
  CHECK(std::abs(branch.energy().residual) < 1e-12 * branch.energy().kinetic_translation);
}

}  // namespace

TEST_CASE("what a lower limit of friction takes from the springs of a state is dissipated, and said") {
  Stretched s;
  REQUIRE(s.before.elastic_tangential > 0);
  s.set_law(0.01);
  const Simulation branch(s.next, s.state, Branching());
  const scree_energy after = branch.energy();
  CHECK(after.elastic_tangential < 0.1 * s.before.elastic_tangential);
  // The springs are shortened along themselves, so that the slip dissipates what they lose, but for
  // round-off.
  CHECK(after.dissipated_friction ==
        Approx(s.before.elastic_tangential - after.elastic_tangential).epsilon(1e-12));
  CHECK(after.work == 0);
  check_closed(branch);
  REQUIRE(branch.let_go().size() == 1);
  CHECK_THAT(branch.let_go()[0],
             Catch::Contains("cut the springs of ") && Catch::Contains(" J, in dissipated_friction"));
}

TEST_CASE("springs that the limit of friction does not reach lose nothing") {
  Stretched s;
  if (GENERATE(false, true)) s.set_law(0.6);
  const Simulation branch(s.next, s.state, Branching());
  // To round-off: springs are projected onto their tangent planes once more.
  CHECK(branch.energy().elastic_tangential == Approx(s.before.elastic_tangential).epsilon(1e-12));
  CHECK(branch.energy().dissipated_friction < 1e-12 * s.before.elastic_tangential);
  CHECK(branch.energy().dissipated_release == 0);
  CHECK(branch.let_go().empty());
}

TEST_CASE("the springs that a scene cannot keep of a state are released in its balance, and said") {
  Stretched s;
  Branching branching;
  std::string why;
  SECTION("left out") {
    branching.histories = false;
    why = "histories are left out";
  }
  SECTION("of a law that has none without friction") {
    s.set_law(0);
    why = "their law keeps other numbers";
  }
  const Simulation branch(s.next, s.state, branching);
  CHECK(branch.energy().elastic_tangential == 0);
  CHECK(branch.energy().dissipated_release == Approx(s.before.elastic_tangential).epsilon(1e-12));
  check_closed(branch);
  REQUIRE(branch.let_go().size() == 1);
  CHECK_THAT(branch.let_go()[0], Catch::Contains(why) && Catch::Contains(" J, in dissipated_release"));
}

TEST_CASE("the energy of contacts with walls that are left out is released in the balance, and said") {
  Stretched s;
  s.next.boundaries.clear();
  s.scene.boundaries.clear();
  const Simulation branch(s.next, s.state, {.walls = false});
  const scree_energy after = branch.energy();
  CHECK(after.dissipated_release == Approx(s.before.elastic_normal + s.before.elastic_tangential -
                                           after.elastic_normal - after.elastic_tangential)
                                        .epsilon(1e-12));
  CHECK(after.dissipated_release > 0);
  check_closed(branch);
  REQUIRE(branch.let_go().size() == 1);
  CHECK_THAT(branch.let_go()[0], Catch::Contains("their walls are left out"));
}

TEST_CASE(
    "springs between bodies that a scene fixes are released, and said, and those of one fixed body are kept") {
  Stretched s;
  for (std::size_t i = 0; i < s.next.bodies.size(); ++i) {
    s.next.bodies[i].fixed = i % 2 == 0;
    if (s.next.bodies[i].fixed) s.next.bodies[i].velocity = s.next.bodies[i].spin = {};
  }
  const auto both_fixed = [&](const scree::ContactList& list, std::size_t c) {
    return list.b[c] < s.next.bodies.size() && s.next.bodies[list.a[c]].fixed &&
           s.next.bodies[list.b[c]].fixed;
  };
  const scree::ContactList before = s.first.contact_list();
  std::size_t dropped = 0;
  for (std::size_t c = 0; c < before.size(); ++c) dropped += both_fixed(before, c);
  REQUIRE(dropped > 0);
  const Simulation branch(s.next, s.state, Branching());
  CHECK(branch.contact_list().size() == before.size() - dropped);
  const scree_energy after = branch.energy();
  CHECK(after.dissipated_release == Approx(s.before.elastic_normal + s.before.elastic_tangential -
                                           after.elastic_normal - after.elastic_tangential)
                                        .epsilon(1e-12));
  CHECK(after.dissipated_release > 0);
  check_closed(branch);
  REQUIRE(branch.let_go().size() == 1);
  CHECK_THAT(branch.let_go()[0], Catch::Contains(std::to_string(dropped) + " contacts lose the springs") &&
                                     Catch::Contains("both of their bodies are fixed"));
}

TEST_CASE("bodies that a scene lets go touch each other and move") {
  Scene scene = heap(2, false);
  scene.bodies[4].position[0] -= 0.3;  // it overlaps with body 3
  for (const std::size_t i : {3, 4}) {
    scene.bodies[i].fixed = true;
    scene.bodies[i].velocity = scene.bodies[i].spin = {};
  }
  const auto touch = [](const Simulation& s) {
    const scree::ContactList list = s.contact_list();
    bool found = false;
    for (std::size_t c = 0; c < list.size(); ++c) found |= list.a[c] == 3 && list.b[c] == 4;
    return found;
  };
  Simulation first(scene);
  scree::test::run(first, steps_of_heap);
  CHECK_FALSE(touch(first));
  Scene next = scene_from(first.state(), scene);
  for (const std::size_t i : {3, 4}) next.bodies[i].fixed = false;
  Simulation branch(next, first.state(), Branching());
  CHECK(touch(branch));
  scree::test::run(branch, steps_of_heap);
  CHECK_FALSE(scree::test::position(branch, 3) == scene.bodies[3].position);
}

TEST_CASE("a scene may begin from a state without one of its walls, whose contacts are released, and said") {
  Stretched s;
  s.next.boundaries[0].parameters.set("y_low", {7});  // absent
  const Simulation branch(s.next, s.state, Branching());
  REQUIRE(branch.absent_walls()[2]);
  CHECK(branch.contact_list().size() < s.first.contact_list().size());
  const scree_energy after = branch.energy();
  CHECK(after.dissipated_release == Approx(s.before.elastic_normal + s.before.elastic_tangential -
                                           after.elastic_normal - after.elastic_tangential)
                                        .epsilon(1e-12));
  CHECK(after.dissipated_release > 0);
  check_closed(branch);
  REQUIRE(branch.let_go().size() == 1);
  CHECK_THAT(branch.let_go()[0], Catch::Contains("their wall or law is absent"));
}

TEST_CASE("a scene may begin from a state without one of its laws") {
  Stretched s;
  REQUIRE(s.first.contact_list().size() > 0);
  s.next.laws[0].parameters.set_absent(true);
  const Simulation branch(s.next, s.state, Branching());
  CHECK(branch.contact_list().size() == 0);
  check_closed(branch);
  REQUIRE_FALSE(branch.let_go().empty());
  CHECK_THAT(branch.let_go().back(), Catch::Contains("their wall or law is absent"));
}
