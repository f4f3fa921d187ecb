#include "cairo/axis_scale.hpp"

#include "drawn_chart.hpp"

#include <catch2/catch.hpp>

using namespace scree::charts;

TEST_CASE("an axis maps its values and the margins at both ends to 0 to 1", "[charts]") {
  const AxisScale linear(2, 6, false, 0.25), logarithmic(1e-2, 1e2, true, 0.25);
  for (const int k : {0, 1, 2, 3, 4}) {
    const double expected = (0.25 + k / 4.0) / 1.5;  // round-off of some operations
    CHECK(std::abs(linear.position(2 + k) - expected) < 1e-15);
    CHECK(std::abs(logarithmic.position(std::pow(10, k - 2)) - expected) < 1e-15);
  }
}

TEST_CASE("between powers of ten a logarithmic axis has eight small ticks", "[charts]") {
  const std::vector<double> ticks = AxisScale(1, 100, true, 0).minor_ticks();
  REQUIRE(ticks.size() == 16);
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(ticks[k] == Approx(double(k) + 2).epsilon(1e-14));
    CHECK(ticks[k + 8] == Approx(10 * (double(k) + 2)).epsilon(1e-14));
  }
  CHECK(AxisScale(1, 1e11, true, 0).minor_ticks().empty());
  CHECK(AxisScale(1, 100, false, 0).minor_ticks().empty());
}

TEST_CASE("labels of an axis are printed with powers of ten", "[charts]") {
  CHECK(AxisScale(1e-6, 2.1e-6, false, 0).ticks(3).labels ==
        std::vector<std::string>{"1.0·10⁻⁶", "1.5·10⁻⁶", "2.0·10⁻⁶"});
  CHECK(AxisScale(1e-3, 1e3, true, 0).ticks(4).labels ==
        std::vector<std::string>{"10⁻³", "0.01", "0.1", "1", "10", "100", "1000"});
}

TEST_CASE("constant, single and huge values have a valid axis", "[charts]") {
  const Trace level = trace(drawn(spec_of({0, 1}, {7, 7})), red);
  CHECK(level.columns > 800);
  CHECK(level.first_row == level.last_row);
  CHECK(trace(drawn(spec_of({0, 1}, {0, 0})), red).columns > 800);
  CHECK(trace(drawn(spec_of({5}, {1e-300})), red).columns > 5);
  CHECK(trace(drawn(spec_of({1e9, 1e9 + 1}, {-1e200, 1e200})), red).columns > 800);
}
