#include "walls/boundaries.hpp"

#include "error_line.hpp"
#include "numbers.hpp"
#include "scripted_boundary.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// The refusal of a scene in its first steps.
std::string refusal_of_script(const Script& now, ExitStatus status) {
  const auto steps = [&] {
    Simulation s(scene_with(now));
    test::run(s, 10);
  };
  return error_line(steps, status);
}

}  // namespace

TEST_CASE("a wall that is not finite, or has no unit normal, is refused at the start by name") {
  for (const double bad : {not_a_number, infinite, -infinite}) {
    for (const char* what : {"point", "normal", "velocity"})
      CHECK_THAT(
          refusal_of_script({.fault = std::string(what) + " at start", .bad = bad}, ExitStatus::bad_input),
          Catch::StartsWith("boundary plug-in scripted, wall mine.only: ") &&
              Catch::Contains(std::string(what == std::string("point") ? "position" : what) + " is (") &&
              Catch::Contains("at the start; correct"));
    CHECK_THAT(refusal_of_script({.fault = "mass", .bad = bad}, ExitStatus::bad_input),
               Catch::StartsWith("boundary plug-in scripted: the mass of wall 1 is "));
    CHECK_THAT(refusal_of_script({.fault = "axis", .bad = bad}, ExitStatus::bad_input),
               Catch::StartsWith("boundary plug-in scripted: the periodic axis y reaches from 0 to "));
  }
  CHECK_THAT(refusal_of_script({.fault = "normal at start", .bad = 2}, ExitStatus::bad_input),
             Catch::Contains("normal has length 2 at the start"));
  CHECK_THAT(refusal_of_script({.fault = "name"}, ExitStatus::bad_input),
             Catch::Contains("scripted: the name of wall 1 is NULL; correct the plug-in"));
  CHECK(refusal_of_script({}, ExitStatus::bad_input) == "no error");
}

TEST_CASE(
    "a wall that is not finite any more stops the run by name and time, also at the end of the last step") {
  for (const double bad : {not_a_number, infinite, -infinite}) {
    CHECK_THAT(
        refusal_of_script({.fault = "point in step", .bad = bad, .from_time = 0.0045}, ExitStatus::blow_up),
        Catch::StartsWith("boundary plug-in scripted, wall mine.only: position is (") &&
            Catch::Contains(" at t = 0.006 s; "));
    CHECK_THAT(
        refusal_of_script({.fault = "velocity at end", .bad = bad, .from_time = 0.0085}, ExitStatus::blow_up),
        Catch::Contains("wall mine.only: velocity is (") && Catch::Contains(" at t = 0.01 s; "));
  }
}

TEST_CASE("a boundary may refuse to start") {
  CHECK(refusal_of_script({.fault = "refusal"}, ExitStatus::bad_input) ==
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
