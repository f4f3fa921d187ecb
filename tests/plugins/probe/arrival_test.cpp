#include "probe_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("arrival: the time at which a column has changed, between observations", "[probe]") {
  Simulation s(scene(3, 1e-3, {body(1, 0.1, 1, {0, 0, 0})}, frictional_law));
  Parameters p = parameters("arrival", SCREE_PROBE, {{"threshold", {0.55}}});
  p.set_input("of", "wall.x", "m");
  Probe probe(p, 3);
  CHECK(probe.units() == std::vector<std::string>{"s", "m"});
  // A signal that falls from 3 by 0.25 each ms: 0.55 after 2.2 ms.
  for (int k = 0; k <= 5; ++k) {
    const double value[] = {3 - 0.25 * k};
    probe.observe(SimulationView(s, 0).get(), value);
    const std::vector<double> row = probe.sample(SimulationView(s, 0).get(), value);
    CHECK(row[1] == Approx(0.25 * k));
    if (k <= 2)
      CHECK(std::isnan(row[0]));
    else
      CHECK(row[0] == Approx(2.2e-3));
    s.step();
  }
}
