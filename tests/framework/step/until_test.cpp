#include "scenes.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/stage.hpp>
#include <scree/until.hpp>

using scree::Condition;
using scree::ConditionValues;
using scree::Error;
using scree::Simulation;
using scree::Stage;
using scree::StageRunner;

namespace {

constexpr double flight_step = 1e-3;

Condition column(const std::string& name, std::size_t number) {
  Condition c;
  c.name = name;
  c.unit = "Pa";
  c.probe = 0;
  c.column = number;
  return c;
}

// One body in free flight, so that any number of steps costs nothing.
Simulation flight() {
  return Simulation(scree::test::scene(2, flight_step, {scree::test::body(1, 1, 1, {}, {{1, 0, 0}}, {}, 2)},
                                       {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}}));
}

// Columns t and 1 - t of a probe with a sample every `every` steps.
struct TimeColumns : scree::StageColumns {
  std::uint64_t every;
  std::optional<double> time = {};
  std::vector<std::uint64_t> taken = {};
  explicit TimeColumns(std::uint64_t steps) : every(steps) {}

  std::uint64_t take(const Simulation& s, const std::string& stage, std::uint64_t steps) override {
    time.reset();
    if (steps % every == 0) time = s.time(), taken.push_back(s.steps());
    return next(s, stage, steps);
  }
  std::uint64_t next(const Simulation&, const std::string&, std::uint64_t steps) const override {
    return steps - steps % every + every;
  }
  std::optional<double> value(std::size_t, std::size_t column) const override {
    if (!time) return std::nullopt;
    return column == 0 ? *time : 1 - *time;
  }
};

Stage ending(const std::vector<Condition>& conditions, double at_most = 10) {
  Stage stage;
  stage.name = "press";
  stage.until.conditions = conditions;
  stage.until.at_most = at_most;
  return stage;
}

std::uint64_t steps_of(const Stage& stage, std::uint64_t every, std::uint64_t chunk) {
  Simulation s = flight();
  StageRunner runner(s, {stage}, std::make_shared<TimeColumns>(every));
  while (!runner.finished()) runner.run(chunk, [] { return true; });
  return s.steps();
}

bool met_after(const Condition& c, const std::vector<double>& values) {
  ConditionValues taken(c);
  for (std::size_t k = 0; k < values.size(); ++k) taken.take(double(k), values[k]);
  return taken.met();
}

}  // namespace

TEST_CASE("a column ends a stage at the first sample at which it is above or below its bound") {
  Condition above = column("stress.zz", 0), below = column("stress.xx", 1);
  above.above = 0.2301;
  below.below = 0.5499;
  // Samples every 25 steps of 1e-3: t = 0.25 is the first above 0.2301; 1 - t = 0.525 the first below 0.5499.
  for (const std::uint64_t chunk : {1, 7, 1000}) {
    CHECK(steps_of(ending({above}), 25, chunk) == 250);
    CHECK(steps_of(ending({below}), 25, chunk) == 475);
    CHECK(steps_of(ending({above, below}), 25, chunk) == 475);
    Stage any = ending({above, below});
    any.until.any = true;
    CHECK(steps_of(any, 25, chunk) == 250);
    // Between samples nothing is tested: the value of the last sample holds already before at_least.
    any.until.at_least = 0.31;
    CHECK(steps_of(any, 25, chunk) == 325);
  }
}

TEST_CASE("a condition compares its latest value, and NaN meets none") {
  Condition c = column("stress.p", 0);
  c.above = 1;
  c.below = 2;
  CHECK_FALSE(met_after(c, {}));
  CHECK(met_after(c, {9, 1.5}));
  CHECK_FALSE(met_after(c, {1.5, 1}));
  CHECK_FALSE(met_after(c, {1.5, 2}));
  CHECK_FALSE(met_after(c, {std::nan("")}));
}

TEST_CASE(
    "a steady value changes by less than a share of its largest within the time, once that time is known") {
  Condition c = column("stress.p", 0);
  c.steady = 0.1;
  c.over = 3;
  CHECK_FALSE(met_after(c, {100, 100, 100}));  // two seconds only
  CHECK(met_after(c, {100, 100, 100, 100}));
  CHECK(met_after(c, {0, 100, 95, 92, 91}));        // 9 of 100 within the last three seconds
  CHECK_FALSE(met_after(c, {0, 100, 95, 92, 90}));  // 10 of 100
  CHECK(met_after(c, {-100, -100, -99, -95}));
  CHECK_FALSE(met_after(c, {0, 0, 0, 0}));
  CHECK_FALSE(met_after(c, {100, std::nan(""), 100, 100}));
}

TEST_CASE("a stage whose conditions are not met in time fails, or the next one begins") {
  Condition never = column("stress.zz", 0);
  never.above = 5;
  Simulation s = flight();
  StageRunner runner(s, {ending({never}, 0.25)}, std::make_shared<TimeColumns>(10));
  try {
    while (true) runner.step();
  } catch (const Error& error) {
    CHECK(error.status() == scree::ExitStatus::not_reached);
    CHECK_THAT(error.what(), Catch::StartsWith("stage 'press': after 0.25 s stress.zz is 0.2") &&
                                 Catch::Contains(" Pa, not above 5; ") &&
                                 Catch::Contains("raise until.at_most"));
  }
  CHECK(runner.status().starts_with("stress.zz = 0.2"));

  Stage patient = ending({never}, 0.25), after;
  patient.until.goes_on = true;
  after.name = "after";
  after.duration = 0.1;
  Simulation t = flight();
  StageRunner going_on(t, {patient, after}, std::make_shared<TimeColumns>(10));
  while (going_on.current() == 0) going_on.step();
  CHECK(going_on.last_end() == scree::StageEnd::at_most);
  CHECK(std::abs(double(t.steps()) - 250) <= 1);  // 250 × 0.001 may be rounded to either side
  while (!going_on.finished()) going_on.step();
  CHECK(going_on.last_end() == scree::StageEnd::duration);
}

TEST_CASE("values of conditions go on with a state") {
  Condition steady = column("stress.p", 1);
  steady.steady = 1e-9;
  steady.over = 0.1;
  Condition later = column("stress.q", 0);
  later.above = 0.2;
  // Never steady, so that the other condition decides; its values are kept.
  Stage stage = ending({steady, later});
  stage.until.any = true;
  Simulation s = flight();
  StageRunner runner(s, {stage}, std::make_shared<TimeColumns>(20));
  for (int k = 0; k < 130; ++k) runner.step();
  scree::State state = s.state();
  runner.save(scree::StateTransfer::saving_to(state).below("stages"));
  const StageRunner restored(s, {stage}, scree::StateTransfer::restoring_from(state).below("stages"),
                             std::make_shared<TimeColumns>(20));
  CHECK(restored.status() == runner.status());
  CHECK_THAT(restored.status(), Catch::Contains("stress.p = 0.88 Pa"));
}

namespace {

// Five discs of 1 kg in a box, three at rest in a row between its walls, and two others.
Simulation row_and(const scree::Body& fourth, const scree::Body& fifth) {
  std::vector<scree::Body> bodies;
  for (int k = 0; k < 3; ++k)
    bodies.push_back(scree::test::body(k + 1, 1, 1, {{0.99 + 1.98 * k, 5, 0}}, {}, {}, 2));
  bodies.push_back(fourth), bodies.push_back(fifth);
  scree::Scene scene =
      scree::test::scene(2, 1e-4, bodies, {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}});
  for (const auto& [point, normal] : {std::pair{scree::Vec3{{0, 0, 0}}, scree::Vec3{{1, 0, 0}}},
                                      std::pair{scree::Vec3{{5.94, 0, 0}}, scree::Vec3{{-1, 0, 0}}}})
    scree::test::add_boundary(scene, "plane",
                              {{"point", {point[0], point[1], 0}}, {"normal", {normal[0], normal[1], 0}}},
                              normal[0] > 0 ? "left" : "right");
  scree::test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "ground");
  scene.spin = true;
  return Simulation(scene);
}

// Of the row: walls of overlap 0.01 and contacts of 0.02. Of a disc on the ground, 0.01 too.
constexpr double wall_energy = 0.5 * 1e4 * 0.01 * 0.01, pair_energy = 0.5 * 1e4 * 0.02 * 0.02;
constexpr double row_energy = 2 * wall_energy + 2 * pair_energy;

scree::Body disc_at(int id, double x, double y, const scree::Vec3& velocity, double spin) {
  return scree::test::body(id, 1, 1, {{x, y, 0}}, velocity, {{0, 0, spin}}, 2);
}

}  // namespace

TEST_CASE("bodies that roll or fly on do not keep a packing from rest, and bodies that bounce do") {
  const scree::Body flying = disc_at(5, 3, 50, {{0, 3, 0}}, 2), resting = disc_at(4, 3, 40, {}, 0);
  const double ground = row_energy + wall_energy;
  CHECK(scree::kinetic_over_elastic(row_and(resting, flying)) == 0);
  // On the ground: spin and velocity along it do not count, ½ v² along the normal does.
  const scree::Body rolling = disc_at(4, 3, 0.99, {{2, 0, 0}}, -2),
                    bouncing = disc_at(4, 3, 0.99, {{2, 0.5, 0}}, -2);
  CHECK(scree::kinetic_over_elastic(row_and(rolling, flying)) == Approx(0).margin(1e-12));
  CHECK(scree::kinetic_over_elastic(row_and(bouncing, flying)) == Approx(0.5 * 0.25 / ground));
}

TEST_CASE("where no body bears load all bodies count") {
  scree::Scene scene = scree::test::scene(2, 1e-4, {disc_at(1, 0, 0.99, {{2, 0, 0}}, 0)},
                                          {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}});
  scree::test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "ground");
  CHECK(scree::kinetic_over_elastic(Simulation(scene)) == Approx(2 / wall_energy));
  scene.boundaries.clear();
  CHECK(std::isinf(scree::kinetic_over_elastic(Simulation(scene))));
}

TEST_CASE("the bodies that keep a packing from rest are named with the way in which they move") {
  // A disc that rolls on the ground, one in flight, and forty at rest.
  const scree::test::Values spring = {{"normal_stiffness", {1e4}}, {"normal_damping", {20}}};
  std::vector<scree::Body> bodies;
  for (int k = 0; k < 40; ++k)
    bodies.push_back(scree::test::body(k + 1, 1, 1, {{3.0 * k, 0.999, 0}}, {}, {}, 2));
  const auto told = [&](scree::Body moving) {
    std::vector<scree::Body> all = bodies;
    all.push_back(moving);
    scree::Scene scene = scree::test::scene(2, 1e-4, all, spring);
    scree::test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "ground");
    scree::test::add_body_force(scene, "gravity", {{"acceleration", {0, -10, 0}}});
    scene.spin = true;
    return scree::movers(Simulation(scene));
  };
  const auto rolling = told(scree::test::body(99, 1, 1, {{-5, 0.999, 0}}, {{1, 0, 0}}, {{0, 0, -1}}, 2));
  REQUIRE(rolling);
  CHECK(rolling->what == "1 of 41 (particle 99) holds 100 % of the kinetic energy, by rolling");
  CHECK_THAT(rolling->cure, Catch::Contains("rolling friction"));
  const auto flying = told(scree::test::body(99, 1, 1, {{-5, 5, 0}}, {{1, 0, 0}}, {}, 2));
  REQUIRE(flying);
  CHECK_THAT(flying->what, Catch::EndsWith("in flight"));
  const auto spinning = told(scree::test::body(99, 1, 1, {{-5, 0.999, 0}}, {{1e-3, 0, 0}}, {{0, 0, 1}}, 2));
  REQUIRE(spinning);
  CHECK_THAT(spinning->what, Catch::EndsWith("by spinning"));
  const auto sliding = told(scree::test::body(99, 1, 1, {{-5, 0.999, 0}}, {{1, 0, 0}}, {}, 2));
  REQUIRE(sliding);
  CHECK_THAT(sliding->what, Catch::EndsWith("by sliding or vibrating"));
}

TEST_CASE("columns are followed from the first stage on if any stage needs one") {
  Condition above = column("stress.zz", 0);
  above.above = 0.5;
  Stage before;
  before.name = "before";
  before.duration = 0.1;
  const auto clock = std::make_shared<TimeColumns>(25);
  Simulation s = flight();
  StageRunner runner(s, {before, ending({above})}, clock);
  while (!runner.finished()) runner.run(1000, [] { return true; });
  REQUIRE(clock->taken.size() > 5);
  CHECK(clock->taken[0] == 0);
  CHECK(clock->taken[1] == 25);
  CHECK(clock->taken[4] == 100);
}
