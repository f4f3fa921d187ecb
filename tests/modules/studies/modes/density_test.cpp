#include "bead_row.hpp"

#include <numbers>

#include <catch2/catch.hpp>

#include <scree/modes/density.hpp>
#include <scree/response/found_modes.hpp>

using namespace scree;
using namespace scree::modes;
using namespace scree::test;

TEST_CASE("the density of states counts all modes, as a dense solver finds them", "[vibration]") {
  const response::LinearSystem system = chain();
  const response::UndampedSystem undamped(system);
  const std::vector<DensityPoint> points = density_of_states(undamped, beads, {.points = 17, .threads = 2});
  const Eigen::ArrayXd squares = modes_of(system).square_frequency.array();
  const auto resting = (squares <= undamped.rounding()).count();
  REQUIRE(points.size() == 17);
  double integral = 0;
  for (const DensityPoint& p : points) {
    const double omega = 2 * std::numbers::pi * p.to_hz;
    CHECK(p.below == std::size_t((squares < omega * omega).count() - resting));
    const double middle = 0.5 * (p.from_hz + p.to_hz);
    CHECK(p.reduced == Approx(p.density / middle));
    integral += p.density * (p.to_hz - p.from_hz) * beads;
  }
  CHECK(integral == Approx(beads));
  CHECK(points.back().below == beads);
}
