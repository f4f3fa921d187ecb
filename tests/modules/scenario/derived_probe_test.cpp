#include "plan_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("the derived probe computes its columns in their order from inputs and the time", "[scenario]") {
  const scenario::Plan plan = plan_of(
      std::string(discs) +
      "[derived]\nratio = 'energy.kinetic_translation / energy.work'\nafter = { formula = '2 ^ derived.ratio - time', unit = '1' }\n"
      "again = { formula = 'max(derived.after, energy.work)', unit = '1' }\n");
  Probe probe = scenario::configured(plan.probes.back(), 2);
  scree_view view = {};
  view.struct_size = sizeof(view);
  view.time = 0.25;
  const auto row = [&](double kinetic, double work) {
    return probe.sample(view, std::vector<double>{kinetic, work});
  };
  CHECK(row(3, 2) == std::vector<double>{1.5, std::pow(2, 1.5) - 0.25, std::pow(2, 1.5) - 0.25});
  CHECK(row(2, 4) == std::vector<double>{0.5, std::pow(2, 0.5) - 0.25, 4});
  CHECK(row(1, 0)[0] == INFINITY);
  CHECK(std::isnan(row(0, 0)[2]));
}
