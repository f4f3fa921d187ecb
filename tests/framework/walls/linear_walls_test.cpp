#include "numbers.hpp"
#include "scripted_boundary.hpp"

#include <string>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// The same with a linear equation.
struct Linear : Scripted {
  void linear(const BoundaryStep& s, LinearWalls& equations) const {
    note("linear", s);
    s.walls[0].point[2] = s.state[0] = 17;
    const auto value = [](const char* what, double sound) {
      return script.fault == std::string("linear ") + what ? script.bad : sound;
    };
    equations.walls[0] = {1,
                          {{0, 0, 2 * value("direction", 0.5)}},
                          value("mass", 2),
                          value("viscosity", 3),
                          value("pressing force", 5 + s.time),
                          value("speed", 6)};
    equations.stiffness(0, 0) = value("stiffness", 4);
  }
};

}  // namespace

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
  Simulation s(scene_with<Linear>({}));
  test::run(s, 3);
  s.reconfigure_boundary("mine", with_number<Linear>(1));
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
  CHECK(equations.walls[0].pressing_force == Approx(5.002));
  CHECK(equations.walls[0].speed == 6);
  CHECK(equations.stiffness_of(0, 0) == 4);
  CHECK(s.linear_walls(s.time() + 0.5, s.planes(), s.surfaces().frames).walls[0].pressing_force ==
        Approx(5.502));
  // What the plug-in wrote into walls and state went into copies.
  CHECK(s.state_hash() == Simulation(s.scene(), before).state_hash());
}

TEST_CASE("linear equations of walls that cannot be are refused by name") {
  for (const auto& [fault, text] :
       {std::pair{"linear mass", "a mass of -1 kg"}, std::pair{"linear viscosity", "a viscosity of -1 kg/s"},
        std::pair{"linear direction", "a direction of length 2"}}) {
    const Simulation s(scene_with<Linear>({.fault = fault, .bad = -1}));
    CHECK_THROWS_WITH(s.linear_walls(),
                      std::string("boundary plug-in scripted, wall mine.only: its linear equation has ") +
                          text + "; correct the plug-in");
  }
  const Simulation s(scene_with<Linear>({.fault = "linear stiffness", .bad = infinite}));
  CHECK_THROWS_WITH(s.linear_walls(), Catch::Contains("a stiffness of inf N/m"));
  const Simulation pressed(scene_with<Linear>({.fault = "linear pressing force", .bad = infinite}));
  CHECK_THROWS_WITH(pressed.linear_walls(), Catch::Contains("a pressing force of inf N"));
  const Simulation driven(scene_with<Linear>({.fault = "linear speed", .bad = infinite}));
  CHECK_THROWS_WITH(driven.linear_walls(), Catch::Contains("a speed of inf m/s"));
}
