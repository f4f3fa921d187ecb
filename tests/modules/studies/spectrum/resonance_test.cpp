#include <algorithm>
#include <complex>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/spectrum/resonance.hpp>

using namespace scree::spectrum;

// A mode of Q 20 and one of a third of its height, 0.8 or 0.5 of its width above: the fit finds both, |H| has one maximum.
TEST_CASE("a shoulder is a peak without a name", "[sound]") {
  const double second = GENERATE(104.0, 102.5);
  const auto pole = [](double f, double f0, double w, double height) {
    return height * f0 * w / std::complex(f0 * f0 - f * f, f * w);
  };
  RoadSpectrum road;
  road.road = "linear";
  road.columns.resize(7);
  for (double f = 80; f < 120; f += 0.25) {
    road.frequencies.push_back(f);
    const std::complex<double> h = pole(f, 100, 5, 1) + pole(f, second, 5, 0.33);
    road.columns[0].response.push_back(h);
    for (std::size_t layer = 1; layer < 7; ++layer)
      road.columns[layer].response.push_back(h * std::sin(0.5 * std::acos(-1.0) * (double(layer) - 0.5) / 6));
  }
  std::vector<scree::scenario::ObservedColumn> observed(7);
  observed[0].unit = "m";
  for (std::size_t layer = 1; layer < 7; ++layer) observed[layer].of_shape = true;
  const auto resonances = resonances_of({road}, observed);
  REQUIRE(resonances.size() == 2);
  CHECK(resonances[1].mode.frequency == Approx(second).epsilon(1e-6));
  CHECK(name_of(resonances[0]) == "λ/4");
  CHECK(name_of(resonances[1]).empty());
}
