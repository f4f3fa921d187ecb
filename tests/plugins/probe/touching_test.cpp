#include "probe_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double channel_step = 1e-5, channel_stiffness = 1e5, channel_mass = 1e-3;

// Body 2 is held between floor and ceiling; body 1, smaller than their distance, flies at 1 m/s at a wall
// 0.02 m away.
Scene channel() {
  const Values law = {{"normal_stiffness", {channel_stiffness}}, {"normal_damping", {0}}};
  Scene s = scene(2, channel_step,
                  {body(1, 0.005, channel_mass, {{0.025, 0.009, 0}}, {{-1, 0, 0}}, {}, 2),
                   body(2, 0.01, channel_mass, {{0.5, 0.009, 0}}, {}, {}, 2)},
                  law);
  add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {1, 0, 0}}});
  add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  add_boundary(s, "plane", {{"point", {0, 0.018, 0}}, {"normal", {0, -1, 0}}});
  return s;
}

Probe touching(const Values& values) { return Probe(parameters("touching", SCREE_PROBE, values), 2); }

}  // namespace

TEST_CASE("touching: how often a body touched, and when last", "[probe]") {
  Simulation s(channel());
  Probe p = touching({{"ids", {2, 1}}});
  REQUIRE(p.observes());
  REQUIRE(p.names() ==
          std::vector<std::string>{"observations", "touched_2", "last_touch_2", "touched_1", "last_touch_1"});
  const auto observe = [&] { p.observe(SimulationView(s, p.needs()).get()); };
  const auto row = [&] { return p.sample(SimulationView(s, p.needs()).get()); };
  observe();
  CHECK(row() == std::vector<double>{1, 1, 0, 0, 0});
  for (int k = 1; k <= 4000; ++k) {
    s.step();
    observe();
  }
  // π √(m/k) from 0.02 s on; the ends are seen to a step.
  const double contact_time = 3.14159265 * std::sqrt(channel_mass / channel_stiffness);
  CHECK(row()[0] == 4001);
  CHECK(row()[1] == 4001);
  CHECK(row()[2] == Approx(4000 * channel_step));
  CHECK(row()[3] == Approx(contact_time / channel_step).margin(1));
  CHECK(row()[4] == Approx(0.02 + contact_time).margin(1.5 * channel_step));
}

TEST_CASE("touching: a body that is given twice or is not there is refused", "[probe]") {
  const Simulation s(channel());
  CHECK_THROWS_WITH(touching({{"ids", {2, 2}}}).check(SimulationView(s, 0).get()),
                    Catch::Contains("list every body"));
  CHECK_THROWS_WITH(touching({{"ids", {3}}}).check(SimulationView(s, 0).get()),
                    Catch::Contains("id 3 does not exist"));
}
