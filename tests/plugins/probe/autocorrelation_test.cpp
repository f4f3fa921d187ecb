#include "probe_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("autocorrelation: velocities under drag decay as its exponential, spins stay", "[probe]") {
  Scene sc = scene(
      3, 1e-4,
      {body(1, 0.1, 2, {0, 0, 0}, {1, 2, 0}, {0, 3, 0}), body(2, 0.1, 2, {9, 0, 0}, {0, 0, -1}, {1, 0, 0})},
      frictional_law);
  add_body_force(sc, "background_damping", {{"translational", {0, 5}}});
  Simulation s(sc);
  Probe probe(parameters("autocorrelation", SCREE_PROBE, {}), 3);
  const auto row = [&] { return probe.sample(SimulationView(s, 0).get()); };
  CHECK(row()[0] == 1);
  CHECK(row()[1] == 1);
  run(s, 2000);
  // Rate γ/m = 2.5 /s for 0.2 s; the integrator errs by (γ h/m)²/12 per step.
  CHECK(row()[0] == Approx(std::exp(-0.5)).epsilon(1e-6));
  CHECK(row()[1] == Approx(1));
}
