#include "plugins/boundaries.hpp"

#include "scenes.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/plugin/boundary.hpp>

using namespace scree;
using scree::test::Values;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

// What the walls below saw and what they are to do wrong; plug-ins have no other way to the test.
struct Script {
  std::string fault = {};  // what goes wrong
  double bad = 0;          // the number that it puts there
  double from_time = 0;    // of faults during steps
  bool linear = false;     // whether the plug-in states a linear equation
  std::vector<std::string> calls = {};
  std::vector<double> times = {}, steps = {};
  std::vector<std::string> names = {};
  double time_before = 0;
  double other_height = 0, other_load = 0, domain_upper = 0, body_lower = 0;
} script;

// A floor at z = 0 of mass 1 kg that moves with 1 m/s along x.
struct Scripted {
  double number = 0;

  static constexpr About about = {"scripted", "for tests", "—", "—"};
  static constexpr const char* names[] = {"only"};
  static constexpr const char* no_names[] = {nullptr};
  static inline double mass = 1;

  void declare(Declaration& d) { d.number("number", number, "", any_number, "a number"); }
  void describe(BoundaryLayout& layout) const {
    layout.walls = 1;
    layout.state = number > 0 ? 2 : 1;
    layout.names = script.fault == "name" ? no_names : names;
    mass = script.fault == "mass" ? script.bad : 1;
    layout.masses = &mass;
    if (script.fault == "still") layout.still = true;
    if (script.fault == "axis") layout.periodic[1] = {0, script.bad};
  }
  const char* start(const BoundaryStep& s) const {
    note("start", s);
    s.walls[0] = {{{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 0}}, {{1, 0, 0}}};
    if (script.fault == "point at start") s.walls[0].point[2] = script.bad;
    if (script.fault == "normal at start") s.walls[0].normal[2] = script.bad;
    if (script.fault == "velocity at start") s.walls[0].velocity[2] = script.bad;
    s.energy.kinetic = 0.5;
    return script.fault == "refusal" ? "the wall has no ground; give it some" : nullptr;
  }
  void begin_step(const BoundaryStep& s) const {
    note("begin", s);
    s.walls[0].point += s.step * s.walls[0].velocity;
    if (script.fault == "point in step" && s.time >= script.from_time) s.walls[0].point[1] = script.bad;
  }
  void finish_step(const BoundaryStep& s) const {
    note("finish", s);
    s.energy.kinetic = 0.5;
    if (script.fault == "velocity at end" && s.time >= script.from_time) s.walls[0].velocity[0] = script.bad;
  }
  void change(const Scripted& before, double time_before, const BoundaryStep& s) const {
    note("change", s);
    CHECK(before.number != number);
    script.time_before = time_before;
    s.walls[0].velocity[0] = 3;
    s.energy.kinetic = 4.5;
    CHECK(s.state[0] == 7);
    if (s.state.size() > 1) CHECK(s.state[1] == (number > 0 ? 0 : 8));
    if (s.state.size() > 1) s.state[1] = 8;
  }

 protected:
  static void note(const char* call, const BoundaryStep& s) {
    script.calls.push_back(call);
    script.times.push_back(s.time);
    script.steps.push_back(s.step);
    s.state[0] = 7;
    const BoundaryScene scene = s.scene();
    script.names.assign(scene.names.begin(), scene.names.end());
    if (scene.walls.size() > 1) {
      script.other_height = scene.walls[0].point[2];
      script.other_load = scene.loads[0].force[2];
    }
    script.domain_upper = scene.periodic[1] ? scene.domain_upper[1] : 0;
    script.body_lower = scene.lower[2];
  }
};

// The same with a linear equation.
struct Linear : Scripted {
  void linear(const BoundaryStep& s, LinearWalls& equations) const {
    note("linear", s);
    s.walls[0].point[2] = s.state[0] = 17;
    const auto value = [](const char* what, double sound) {
      return script.fault == std::string("linear ") + what ? script.bad : sound;
    };
    equations.walls[0] = {1, {{0, 0, 2 * value("direction", 0.5)}}, value("mass", 2), value("viscosity", 3)};
    equations.stiffness(0, 0) = value("stiffness", 4);
  }
};

template <class Author>
const scree_plugin& scripted() {
  using namespace scree::detail;
  static const scree_boundary interface = {sizeof(scree_boundary),       sizeof(Author),
                                           &configure_boundary<Author>,  &start_boundary<Author>,
                                           &begin_boundary_step<Author>, &finish_boundary_step<Author>,
                                           change_of<Author>(),          linear_of<Author>()};
  return *manifest_of<Author>(SCREE_BOUNDARY, interface);
}

Parameters with_number(double number) {
  Parameters p(script.linear ? scripted<Linear>() : scripted<Scripted>());
  p.set("number", {number});
  return p;
}

Scene scene_with(const Script& now) {
  script = now;
  Scene s = test::scene(3, 1e-3, {test::body(1, 0.1, 1, {{0, 0.5, 5}})},
                        {{"normal_stiffness", {1e3}}, {"normal_damping", {0}}});
  s.boundaries.push_back({"mine", 0, with_number(0)});
  return s;
}

// The refusal of a scene in its first steps.
std::string refusal(const Script& now, ExitStatus status) {
  try {
    Simulation s(scene_with(now));
    test::run(s, 10);
  } catch (const Error& error) {
    CHECK(error.status() == status);
    return error.what();
  }
  return "went on";
}

}  // namespace

TEST_CASE("a wall that is not finite, or has no unit normal, is refused at the start by name") {
  for (const double bad : {not_a_number, infinite, -infinite}) {
    for (const char* what : {"point", "normal", "velocity"})
      CHECK_THAT(
          refusal({.fault = std::string(what) + " at start", .bad = bad}, ExitStatus::bad_input),
          Catch::StartsWith("boundary plug-in scripted, wall mine.only: ") &&
              Catch::Contains(std::string(what == std::string("point") ? "position" : what) + " is (") &&
              Catch::Contains("at the start; correct"));
    CHECK_THAT(refusal({.fault = "mass", .bad = bad}, ExitStatus::bad_input),
               Catch::StartsWith("boundary plug-in scripted: the mass of wall 1 is "));
    CHECK_THAT(refusal({.fault = "axis", .bad = bad}, ExitStatus::bad_input),
               Catch::StartsWith("boundary plug-in scripted: the periodic axis y reaches from 0 to "));
  }
  CHECK_THAT(refusal({.fault = "normal at start", .bad = 2}, ExitStatus::bad_input),
             Catch::Contains("normal has length 2 at the start"));
  CHECK_THAT(refusal({.fault = "name"}, ExitStatus::bad_input),
             Catch::Contains("scripted: the name of wall 1 is NULL; correct the plug-in"));
  CHECK(refusal({}, ExitStatus::bad_input) == "went on");
}

TEST_CASE(
    "a wall that is not finite any more stops the run by name and time, also at the end of the last step") {
  for (const double bad : {not_a_number, infinite, -infinite}) {
    CHECK_THAT(refusal({.fault = "point in step", .bad = bad, .from_time = 0.0045}, ExitStatus::blow_up),
               Catch::StartsWith("boundary plug-in scripted, wall mine.only: position is (") &&
                   Catch::Contains(" at t = 0.006 s; "));
    CHECK_THAT(refusal({.fault = "velocity at end", .bad = bad, .from_time = 0.0085}, ExitStatus::blow_up),
               Catch::Contains("wall mine.only: velocity is (") && Catch::Contains(" at t = 0.01 s; "));
  }
}

TEST_CASE("a boundary may refuse to start") {
  CHECK(refusal({.fault = "refusal"}, ExitStatus::bad_input) ==
        "scripted: the wall has no ground; give it some");
}

TEST_CASE("a boundary is started, and called twice for each substep with a step that is not 0") {
  const Scene scene = scene_with({});
  Simulation s(scene);
  CHECK(script.calls.back() == "start");
  CHECK(script.steps.back() == 0);
  script = {};
  test::run(s, 2);
  CHECK(script.calls == std::vector<std::string>{"begin", "finish", "begin", "finish"});
  CHECK(script.steps == std::vector<double>{1e-3, 1e-3, 1e-3, 1e-3});
  CHECK(script.times == std::vector<double>{0, 0, 1e-3, 1e-3});

  Scene substeps = scene;
  substeps.integration = Integration::fourth_order;
  Simulation fourth(substeps);
  script = {};
  test::run(fourth, 1);
  REQUIRE(script.steps.size() == 10);
  CHECK(script.steps[4] < 0);
  CHECK(script.steps[5] == script.steps[4]);

  script.fault = "still";
  Simulation still(scene);
  script.calls.clear();
  test::run(still, 2);
  CHECK(script.calls.empty());
}

TEST_CASE(
    "a change of parameters shows the old ones, restarts the clock, and counts kinetic energy as work") {
  Simulation s(scene_with({}));
  test::run(s, 3);
  CHECK(s.energy().kinetic_boundary == 0.5);
  CHECK(s.energy().residual == 0);
  s.reconfigure_boundary("mine", with_number(1));  // one number of state more
  CHECK(script.calls.back() == "change");
  CHECK(script.times.back() == 0);
  CHECK(script.steps.back() == 0);
  CHECK(script.time_before == Approx(3e-3));  // the time by the old clock
  s.apply_reconfiguration();
  CHECK(s.planes()[0].velocity[0] == 3);
  CHECK(s.energy().kinetic_boundary == 4.5);
  CHECK(s.energy().work == 4);
  CHECK(s.energy().residual == 0);
  test::run(s, 1);
  CHECK(script.times.back() == 0);
  s.reconfigure_boundary("mine", with_number(-1));  // and one less
  CHECK(script.time_before == Approx(1e-3));
}

TEST_CASE("a wall that is still from now on has no velocity and no kinetic energy") {
  Simulation s(scene_with({}));
  test::run(s, 3);
  script.fault = "still";
  s.reconfigure_boundary("mine", with_number(1));
  CHECK(s.planes()[0].velocity[0] == 0);
  CHECK(s.planes()[0].mid_velocity[0] == 0);
}

TEST_CASE("a boundary sees the walls and loads of the others, the bodies and the periodic axes") {
  Scene scene = scene_with({});
  scene.bodies[0].position[2] = 5.15;
  const Scene::Boundary mine = scene.boundaries[0];
  scene.boundaries.clear();
  test::add_boundary(scene, "periodic", {{"axes", {1}}, {"lower", {0, 0, 0}}, {"upper", {0, 1, 0}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 5.1}}, {"normal", {0, 0, 1}}}, "floor");
  scene.boundaries.push_back(mine);
  Simulation s(scene);
  CHECK(script.names == std::vector<std::string>{"floor", "mine.only"});
  CHECK(script.other_height == 5.1);
  CHECK(script.other_load == 0);
  CHECK(script.domain_upper == 1);
  CHECK(script.body_lower == Approx(5.05));
  test::run(s, 1);
  CHECK(script.other_load == s.loads()[0].force[2]);
  CHECK(script.other_load == Approx(-50).epsilon(1e-3));
}

TEST_CASE("walls whose boundary states nothing are prescribed along their normals") {
  const Simulation s(scene_with({}));
  const WallEquations equations = s.linear_walls();
  REQUIRE(equations.walls.size() == 1);
  CHECK(equations.walls[0].free == 0);
  CHECK(equations.walls[0].direction[2] == 1);
  CHECK(equations.stiffness == std::vector<double>{0});
}

TEST_CASE(
    "a boundary states the linear equations of its walls, with the time since its parameters were set") {
  Simulation s(scene_with({.linear = true}));
  test::run(s, 3);
  s.reconfigure_boundary("mine", with_number(1));
  s.apply_reconfiguration();
  test::run(s, 2);
  const State before = s.state();
  const WallEquations equations = s.linear_walls();
  CHECK(script.calls.back() == "linear");
  CHECK(script.times.back() == Approx(2e-3));
  CHECK(script.steps.back() == 0);
  CHECK(equations.walls[0].free == 1);
  CHECK(equations.walls[0].mass == 2);
  CHECK(equations.walls[0].viscosity == 3);
  CHECK(equations.stiffness_of(0, 0) == 4);
  // What the plug-in wrote into walls and state went into copies.
  CHECK(s.state_hash() == Simulation(s.scene(), before).state_hash());
}

TEST_CASE("linear equations of walls that cannot be are refused by name") {
  for (const auto& [fault, text] :
       {std::pair{"linear mass", "a mass of -1 kg"}, std::pair{"linear viscosity", "a viscosity of -1 kg/s"},
        std::pair{"linear direction", "a direction of length 2"}}) {
    const Simulation s(scene_with({.fault = fault, .bad = -1, .linear = true}));
    CHECK_THROWS_WITH(s.linear_walls(),
                      std::string("boundary plug-in scripted, wall mine.only: its linear equation has ") +
                          text + "; correct the plug-in");
  }
  const Simulation s(scene_with({.fault = "linear stiffness", .bad = infinite, .linear = true}));
  CHECK_THROWS_WITH(s.linear_walls(), Catch::Contains("a stiffness of inf N/m"));
}
