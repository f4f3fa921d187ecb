#include "linear.hpp"

#include "chain.hpp"

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>

using namespace scree;
using namespace scree::sound;
using namespace scree::test;

TEST_CASE("the linear road gives the response of the discrete chain", "[sound]") {
  const Chain chain;
  const scenario::Plan plan =
      plan_of(chain.text("from_hz = 20\nto_hz = 160\nstep_hz = 1\nfewest_contacts = 1\n"));
  const Start start{plan, plan.scene, run::set_up(plan)->state()};
  const RoadSpectrum road = linear_spectrum(start);
  REQUIRE(road.frequencies.size() == 141);
  for (std::size_t k = 0; k < road.frequencies.size(); ++k)
    for (const std::size_t c : {0u, 1u}) {
      CAPTURE(road.frequencies[k], c);
      const std::complex<double> exact = chain.response(c == 0 ? 1 : Chain::beads, road.frequencies[k]);
      // Round-off of a height of 0.08 m in a difference of up to 5e-6 m: 1.4e-17/5e-6 = 3e-12.
      CHECK(std::abs(road.columns[c].response[k] - exact) < 1e-10 * std::abs(exact) + 1e-11);
    }
}
