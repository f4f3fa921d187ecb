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

TEST_CASE("a linear road that was stopped goes on with the frequencies that it lacks", "[sound]") {
  const Chain chain;
  const scenario::Plan plan =
      plan_of(chain.text("from_hz = 20\nto_hz = 160\nstep_hz = 1\nfewest_contacts = 1\n"));
  std::atomic<bool> stop = true;
  const Start start{plan, plan.scene, run::set_up(plan)->state(), &stop};
  RoadSpectrum road;
  CHECK(!add_linear(start, road));
  CHECK(road.frequencies.empty());
  stop = false;
  const RoadSpectrum whole = linear_spectrum(start);
  // As if it had been stopped behind the frequencies in the middle.
  road = whole;
  road.frequencies.erase(road.frequencies.begin() + 40, road.frequencies.begin() + 99);
  for (RoadSpectrum::Column& column : road.columns) {
    column.response.erase(column.response.begin() + 40, column.response.begin() + 99);
    column.error.erase(column.error.begin() + 40, column.error.begin() + 99);
    column.linearity.assign(column.response.size(), 0);
  }
  CHECK(add_linear(start, road));
  CHECK(road.frequencies == whole.frequencies);
  for (const std::size_t c : {0u, 1u}) {
    CHECK(road.columns[c].response == whole.columns[c].response);
    CHECK(road.columns[c].error == whole.columns[c].error);
    CHECK(road.columns[c].linearity.empty());
  }
}
