#include "contacts/contacts.hpp"
#include "error_line.hpp"
#include "scenes.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <scree/energy.hpp>
#include <scree/error.hpp>
#include <scree/stage.hpp>

using scree::Error;
using scree::Scene;
using scree::Simulation;
using scree::Stage;
using scree::StageRunner;
using scree::test::error_line;
using scree::test::Values;

namespace {

constexpr double stage_step = 1e-3, disc_stiffness = 1e4, disc_mass = 1, disc_radius = 1, disc_gravity = 10;
const std::string disc_law = "linear_spring_dashpot";

Values disc_spring(double damping, double friction = 0) {
  return {{"normal_stiffness", {disc_stiffness}},
          {"normal_damping", {damping}},
          {"tangential_stiffness", {disc_stiffness}},
          {"static_friction", {friction}}};
}

// A disc on the ground, moving along it.
Scene disc(double friction, double speed, double spin = 0, double damping = 20) {
  Scene s =
      scree::test::scene(2, stage_step,
                         {scree::test::body(7, disc_radius, disc_mass,
                                            {{0, disc_radius - disc_mass * disc_gravity / disc_stiffness, 0}},
                                            {{speed, 0, 0}}, {{0, 0, spin}}, 2)},
                         disc_spring(damping, friction));
  scree::test::add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "ground");
  scree::test::add_body_force(s, "gravity", {{"acceleration", {0, -disc_gravity, 0}}});
  return s;
}

Stage::Change friction_change(double friction, double damping = 20) {
  return {SCREE_CONTACT_LAW, disc_law,
          scree::test::parameters(disc_law, SCREE_CONTACT_LAW, disc_spring(damping, friction))};
}

Stage lasting(const std::string& name, double duration, const std::vector<Stage::Change>& changes = {}) {
  Stage stage;
  stage.name = name;
  stage.changes = changes;
  stage.duration = duration;
  return stage;
}

Stage settling(double kinetic_over_elastic, double at_least, std::optional<double> at_most) {
  Stage stage;
  stage.name = "settle";
  scree::Condition rest;
  rest.name = "kinetic_over_elastic";
  rest.below = kinetic_over_elastic;
  stage.until = {.conditions = {rest}, .at_least = at_least, .at_most = at_most};
  return stage;
}

std::uint32_t history_width(const Simulation& s) {
  std::uint32_t width = 0;
  for (const scree::PairGroup& group : s.contacts().groups()) width = std::max(width, group.history_width);
  return width;
}

double spin_of(const Simulation& s) { return s.particles().body(0).spin[2]; }

}  // namespace

TEST_CASE("stages last their durations, to the step, and follow each other") {
  Simulation s(disc(0, 0));
  StageRunner runner(s, {lasting("first", 0.1), lasting("second", 0.05)});
  CHECK_FALSE(runner.finished());
  CHECK(*runner.progress() == 0);
  for (int k = 1; k < 100; ++k) runner.step();
  CHECK(runner.current() == 0);
  CHECK(*runner.progress() == Approx(99.0 / 150));
  runner.step();
  CHECK(runner.current() == 1);
  CHECK(runner.began() == s.time());
  for (int k = 1; k < 50; ++k) runner.step();
  CHECK_FALSE(runner.finished());
  runner.step();
  CHECK(runner.finished());
  CHECK(s.steps() == 150);
  CHECK(*runner.progress() == Approx(1));
  CHECK(StageRunner(s, {}).finished());  // a run without stages is finished at once
}

TEST_CASE("a condition ends a stage when kinetic over elastic energy has fallen below it") {
  // Damped bouncing: the disc starts above its rest, so that energies are well above the condition at first.
  Scene scene = disc(0, 0);
  scene.bodies[0].position[1] += 0.01;
  const double condition = 1e-6;
  const auto ratio = [](const Simulation& s) {
    return scree::kinetic_energy(s.energy()) / scree::elastic_energy(s.energy());
  };

  Simulation s(scene);
  StageRunner runner(s, {settling(condition, 0, 10)});
  double before = 0;
  while (!runner.finished()) {
    if (s.steps() % 100 == 0) before = ratio(s);
    runner.step();
  }
  CHECK(ratio(s) < condition);
  CHECK(before >= condition);  // at the previous test it was not fulfilled

  // Not before at_least, even if it is fulfilled.
  Simulation t(scene);
  const double at_least = s.time() + 1;
  StageRunner patient(t, {settling(condition, at_least, {})});
  while (!patient.finished()) patient.step();
  CHECK(t.time() >= at_least - 1e-9);
  CHECK(t.time() <= at_least + 100.5 * stage_step);
}

TEST_CASE("progress is known only while what remains has a duration") {
  Scene scene = disc(0, 0);
  scene.bodies[0].position[1] += 0.01;
  Simulation s(scene);
  StageRunner runner(s, {lasting("fall", 0.1), settling(1e-3, 0, 1000), lasting("after", 0.05)});
  runner.step();
  CHECK_FALSE(runner.progress().has_value());
  while (runner.current() == 0) runner.step();
  CHECK(runner.status().empty());
  for (int k = 0; k < 100; ++k) runner.step();
  REQUIRE(runner.current() == 1);
  CHECK_FALSE(runner.progress().has_value());
  CHECK(runner.status() ==
        fmt::format("kinetic_over_elastic = {:.3g}, below 0.001",
                    scree::kinetic_energy(s.energy()) / scree::elastic_energy(s.energy())));
  while (runner.current() == 1) runner.step();
  CHECK(*runner.progress() == Approx(s.time() / (s.time() + 0.05)));
}

TEST_CASE("bodies in free flight have no elastic energy and do not fulfil the condition") {
  Simulation s(
      scree::test::scene(2, stage_step, {scree::test::body(0, 1, 1, {}, {}, {}, 2)}, disc_spring(0)));
  StageRunner runner(s, {settling(1e-6, 0, 1)});
  CHECK_THROWS_AS(
      [&] {
        for (int k = 0; k < 1001; ++k) runner.step();
      }(),
      Error);
}

TEST_CASE("a condition not fulfilled in time is a failure with stage, value and remedy") {
  Simulation s(disc(0, 1, 0, 0));  // slides without end
  StageRunner runner(s, {settling(1e-3, 0, 0.25)});
  int steps = 0;
  const std::string text = error_line(
      [&] {
        for (;;) runner.step(), ++steps;
      },
      scree::ExitStatus::not_reached);
  CHECK(std::abs(steps - 249) <= 1);  // 250 × 0.001 may be rounded to either side
  CHECK_THAT(
      text, Catch::StartsWith("stage 'settle': after 0.25 s kinetic_over_elastic is ") &&
                Catch::Contains(
                    ", not below 0.001: 1 of 1 (particle 7) holds 100 % of the kinetic energy, by sliding") &&
                Catch::Contains("raise until.at_most"));
}

TEST_CASE("friction can be switched on when spins are carried, and its springs appear") {
  Scene scene = disc(0, 1, 3);
  scene.spin = true;
  Simulation s(scene);
  StageRunner runner(s, {lasting("slide", 0.05), lasting("grip", 0.05, {friction_change(0.5)}),
                         lasting("let go", 0.05, {friction_change(0)})});
  CHECK(history_width(s) == 0);
  while (runner.current() == 0) runner.step();
  CHECK(scree::test::velocity(s, 0)[0] == 1);
  CHECK(history_width(s) == 3);  // applies from the start of the stage: two springs, sliding state
  while (runner.current() == 1) {
    runner.step();
    if (s.steps() == 51) {
      // Within the first step sliding at 1 + 3 × (R − δ/2) m/s it has stretched the spring k_t to the limit.
      const double pressure = disc_mass * disc_gravity,
                   torque = 0.5 * pressure * (disc_radius - 0.5 * pressure / disc_stiffness);
      CHECK(s.particles().torque()[2][0] == Approx(-torque).epsilon(1e-9));
      CHECK(spin_of(s) == Approx(3 - 0.5 * stage_step * torque / s.particles().inertia[0]).epsilon(1e-9));
    }
  }
  CHECK(history_width(s) == 0);
  const double spin = spin_of(s), speed = scree::test::velocity(s, 0)[0];
  CHECK(spin < 3);
  CHECK(speed < 1);
  while (!runner.finished()) runner.step();
  CHECK(spin_of(s) == spin);  // no torque acts now
  CHECK(std::abs(scree::test::velocity(s, 0)[0] - speed) <=
        0.5 * stage_step * 0.5 * disc_gravity * (1 + 1e-9));
}

TEST_CASE("springs are kept when a stage changes other parameters of their law") {
  Simulation s(disc(0.5, 1));
  StageRunner runner(s, {lasting("slide", 0.02), lasting("damped", 0.02, {friction_change(0.5, 30)})});
  for (int k = 0; k < 19; ++k) runner.step();
  const auto stretched = [&] {
    const scree::PairGroup& group = s.contacts().groups()[1];
    REQUIRE((group.planes && group.end > group.begin));
    return group.history.column(0)[0];
  };
  Simulation uninterrupted(disc(0.5, 1));
  scree::test::run(uninterrupted, 20);
  runner.step();
  REQUIRE(runner.current() == 1);
  CHECK(stretched() == uninterrupted.contacts().groups()[1].history.column(0)[0]);
  CHECK(stretched() != 0);
}

TEST_CASE("what the first stage sets and the scene has from the start is not set again") {
  Scene scene = disc(0.5, 1);
  Simulation s(scene);
  const std::uint64_t searches = s.rebuilds();
  const StageRunner runner(s, {lasting("slide", 0.02, {friction_change(0.5)})});
  CHECK(s.rebuilds() == searches);
  const StageRunner other(s, {lasting("slide", 0.02, {friction_change(0.4)})});
  CHECK(s.rebuilds() == searches + 1);
}

TEST_CASE("springs that a stage cuts are dissipated, and not work") {
  Simulation s(disc(0.5, 1));
  StageRunner runner(s, {lasting("slide", 0.02), lasting("smoother", 0.02, {friction_change(0.1)})});
  for (int k = 0; k < 19; ++k) runner.step();
  Simulation uninterrupted(disc(0.5, 1));
  scree::test::run(uninterrupted, 20);
  runner.step();
  REQUIRE(runner.current() == 1);
  const scree_energy before = uninterrupted.energy(), after = s.energy();
  const double lost = before.elastic_tangential - after.elastic_tangential;
  CHECK(lost > 0);
  CHECK(after.dissipated_friction - before.dissipated_friction ==
        Approx(lost).epsilon(1e-9));  // round-off of the sums
  CHECK(after.work - before.work == Approx(0).margin(1e-12 * before.kinetic_translation));
  CHECK(after.residual == Approx(before.residual).margin(1e-12 * before.kinetic_translation));
}

TEST_CASE("switching on friction in a scene without spins is refused") {
  Simulation s(disc(0, 1));
  CHECK_FALSE(s.particles().has_spin());
  const std::string text = error_line([&] { StageRunner(s, {lasting("grip", 1, {friction_change(0.5)})}); },
                                      scree::ExitStatus::bad_input);
  CHECK_THAT(text, Catch::Contains(disc_law) && Catch::Contains("spin"));
}

TEST_CASE("names of changes must exist") {
  Simulation s(disc(0, 1));
  for (const scree_kind kind : {SCREE_CONTACT_LAW, SCREE_BOUNDARY, SCREE_BODY_FORCE}) {
    Stage::Change change = friction_change(0);
    change.kind = kind;
    change.name = "nobody";
    const std::string text =
        error_line([&] { StageRunner(s, {lasting("odd", 1, {change})}); }, scree::ExitStatus::bad_input);
    CHECK_THAT(text, Catch::Contains("'nobody'"));
  }
}

TEST_CASE(
    "body forces and walls change with a stage: a wall's clock starts again and the wall does not jump") {
  const auto gravity_of = [](double g) {
    return scree::test::parameters("gravity", SCREE_BODY_FORCE, {{"acceleration", {0, -g, 0}}});
  };
  const auto lift = [](const std::vector<double>& displacement) {
    return scree::test::parameters(
        "plane", SCREE_BOUNDARY,
        {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}, {"displacement", displacement}});
  };
  Scene scene = disc(0, 0);
  scene.boundaries[0].parameters = lift({3, 0, 0.1, 0.1});  // 1 m/s for 0.1 s
  Simulation s(scene);
  StageRunner runner(s, {lasting("up", 0.05), lasting("down", 0.02,
                                                      {{SCREE_BOUNDARY, "ground", lift({3, 0, -0.2, 0.1})},
                                                       {SCREE_BODY_FORCE, "gravity", gravity_of(0)}})});
  while (runner.current() == 0) runner.step();
  const auto height = [&] { return s.planes()[0].point[1]; };
  // Sums of up to 50 displacements of the ramp, each rounded as a difference of up to 0.1 m.
  CHECK(std::abs(height() - 0.05) <= 50 * 2.3e-16 * 0.2);
  CHECK(s.planes()[0].velocity[1] == Approx(-2));  // of the new program, at once
  while (!runner.finished()) runner.step();
  CHECK(std::abs(height() - (0.05 - 2 * 0.02)) <= 70 * 2.3e-16 * 0.4);
  CHECK(s.particles().force()[1][0] >= 0);  // the wall still pushes, or not, but no force acts downwards
}

TEST_CASE("a wall that a stage fixes stays where its motion has brought it") {
  const auto ground = [](double control) {
    return scree::test::parameters("plane", SCREE_BOUNDARY,
                                   {{"point", {0, 0, 0}},
                                    {"normal", {0, 1, 0}},
                                    {"control", {control}},
                                    {"displacement", {3, 0, 0.1, 0.1}}});  // 1 m/s for 0.1 s
  };
  constexpr double fixed = 0, displaced = 1;
  Scene scene = disc(0, 0);
  scene.boundaries[0].parameters = ground(displaced);
  Simulation s(scene);
  StageRunner runner(
      s, {lasting("up", 0.05), lasting("still", 0.02, {{SCREE_BOUNDARY, "ground", ground(fixed)}})});
  while (runner.current() == 0) runner.step();
  const double height = s.planes()[0].point[1];
  CHECK(height == Approx(0.05));
  while (!runner.finished()) runner.step();
  CHECK(s.planes()[0].point[1] == height);
  CHECK(s.planes()[0].velocity[1] == 0);
}
