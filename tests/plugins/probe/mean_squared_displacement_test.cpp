#include "error_line.hpp"
#include "probe_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/probes.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const Values elastic = {{"normal_stiffness", {5000}}, {"normal_damping", {0}}};
constexpr double drift_step = 1e-3, period = 1;

// Two bodies that never meet in a box that is periodic along x and y. In 400 steps, 0.4 s, the first crosses
// the face x = 1 three times, the second y = 0 once.
Scene drifting(int dimension) {
  const double z = dimension == 3 ? 0.5 : 0;
  Scene s = scene(dimension, drift_step,
                  {body(4, 0.01, 1, {{0.5, 0.25, z}}, {{8, 0, z}}, {}, dimension),
                   body(2, 0.02, 3, {{0.5, 0.75, z}}, {{0, -2.25, 0}}, {}, dimension)},
                  elastic);
  add_boundary(s, "periodic", {{"lower", {0, 0, 0}}, {"upper", {period, period, period}}, {"axes", {3}}});
  return s;
}

Probe displacement(const Values& values, int dimension) {
  return Probe(parameters("mean_squared_displacement", SCREE_PROBE, values), dimension);
}

}  // namespace

TEST_CASE("mean_squared_displacement: bodies at constant velocity across periodic faces", "[probe]") {
  for (const int dimension : {2, 3}) {
    Simulation s(drifting(dimension));
    Probe all = displacement({}, dimension), one = displacement({{"ids", {2}}}, dimension);
    for (Probe* p : {&all, &one}) {
      CHECK_FALSE(p->observes());
      CHECK(p->sample(SimulationView(s, 0).get()) == std::vector<double>(std::size_t(dimension) + 1, 0.0));
    }
    run(s, 400);
    const double z2 = dimension == 3 ? 0.25 : 0, t2 = 0.16;
    const std::vector<double> of_all = all.sample(SimulationView(s, 0).get());
    const std::vector<double> of_one = one.sample(SimulationView(s, 0).get());
    REQUIRE(s.particles().image[0][0] == 3);
    REQUIRE(s.particles().image[1][1] == -1);
    // Each of 400 steps rounds a coordinate of up to 1 m; the shortest distance is 0.2 m, squared.
    const double rounding = 400 * 1.1e-16 / 0.2 * 2;
    CHECK(of_all[0] == Approx((64 + z2 + 2.25 * 2.25) / 2 * t2).epsilon(rounding));
    CHECK(of_all[1] == Approx(32 * t2).epsilon(rounding));
    CHECK(of_all[2] == Approx(2.25 * 2.25 / 2 * t2).epsilon(rounding));
    if (dimension == 3) CHECK(of_all[3] == Approx(z2 / 2 * t2).epsilon(rounding));
    CHECK(of_one[0] == Approx(2.25 * 2.25 * t2).epsilon(rounding));
  }
}

TEST_CASE("mean_squared_displacement: with a window, the mean over the windows that are complete",
          "[probe]") {
  Simulation s(drifting(3));
  Probe p = displacement({{"window", {0.05}}}, 3);
  REQUIRE(p.observes());
  const auto observe = [&] { p.observe(SimulationView(s, p.needs()).get()); };
  const auto total = [&] { return p.sample(SimulationView(s, p.needs()).get())[0]; };
  observe();
  for (int k = 1; k <= 120; ++k) {
    s.step();
    observe();
    if (k == 49) CHECK(std::isnan(total()));
    if (k == 50) CHECK(total() == Approx((64.25 + 2.25 * 2.25) / 2 * 0.0025).epsilon(1e-12));
  }
  CHECK(p.state()[1] == 2);
  CHECK(total() == Approx((64.25 + 2.25 * 2.25) / 2 * 0.0025).epsilon(1e-12));
}

TEST_CASE("mean_squared_displacement: a time without observations is no window", "[probe]") {
  Simulation s(drifting(3));
  Probe p = displacement({{"window", {0.05}}}, 3);
  const auto observe = [&] { p.observe(SimulationView(s, p.needs()).get()); };
  observe();
  run(s, 80);
  observe();  // 0.03 s late
  CHECK(p.state()[1] == 0);
  CHECK(std::isnan(p.sample(SimulationView(s, 0).get())[0]));
  run(s, 50);
  observe();
  CHECK(p.state()[1] == 1);
  CHECK(p.sample(SimulationView(s, 0).get())[0] == Approx((64.25 + 2.25 * 2.25) / 2 * 0.0025).epsilon(1e-12));
}

TEST_CASE("mean_squared_displacement: a body given twice is refused", "[probe]") {
  const Simulation s(drifting(3));
  CHECK_THROWS_WITH(displacement({{"ids", {2, 2}}}, 3).check(SimulationView(s, 0).get()),
                    Catch::Contains("the id 2 is given twice"));
}

TEST_CASE("mean_squared_displacement: of bodies that a scenario chooses", "[probe]") {
  Simulation s(drifting(2));
  const auto without_first = [&](const Values& values) {
    return Probe(parameters("mean_squared_displacement", SCREE_PROBE, values), 2, {1, 0});
  };
  Probe second = without_first({}), listed = without_first({{"ids", {2}}}),
        both = without_first({{"ids", {2, 4}}});
  for (Probe* p : {&second, &listed}) p->sample(SimulationView(s, 0).get());
  CHECK_THAT(error_line([&] { both.sample(SimulationView(s, 0).get()); }),
             Catch::Contains("body 4 of ids is one that groups and leave_out do not count; remove its id"));
  run(s, 400);
  CHECK(second.sample(SimulationView(s, 0).get())[0] == Approx(2.25 * 2.25 * 0.16));
  CHECK(listed.sample(SimulationView(s, 0).get())[0] == Approx(2.25 * 2.25 * 0.16));
}
