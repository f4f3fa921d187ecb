#include "settling.hpp"

#include "noise.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::cycles;
using namespace scree::test;

namespace {

template <class Strain>
Settling settling_to(std::size_t count, const Strain& strain) {
  std::vector<double> values;
  for (std::size_t n = 0; n < count; ++n) values.push_back(strain(double(n)));
  return settling_of(values);
}

}  // namespace

TEST_CASE("increments that fall are in the order of their places", "[settling]") {
  const Settling found = settling_to(72, [](double n) { return 5 + std::exp(-n / 20); });
  CHECK(found.correlation == Approx(-1).epsilon(1e-14));
  CHECK(found.probability == 0);
  CHECK(found.block == 1);
  CHECK(found.increments == 71);
  CHECK(found.lengths == 4);  // 1, 2, 4 and 8 cycles, of which 72 have nine
}

TEST_CASE("increments that grow, or are all equal, do not settle", "[settling]") {
  const Settling grown = settling_to(72, [](double n) { return std::exp(n / 20); });
  CHECK(grown.correlation == Approx(1).epsilon(1e-14));
  CHECK(grown.probability == 1);
  CHECK(settling_to(72, [](double n) { return 3 * n; }).correlation == 0);
  CHECK(settling_to(7, [](double n) { return std::exp(-n); }).lengths == 0);
}

// In single cycles 20 and a little more alternates with 20 and a little less; over two cycles it cancels.
TEST_CASE("noise above the strain per cycle hides it in single cycles and not in blocks", "[settling]") {
  const Settling found =
      settling_to(72, [](double n) { return std::exp(-n / 30) + 10 * std::cos(std::numbers::pi * n); });
  CHECK(found.block == 2);
  CHECK(found.increments == 35);
  CHECK(found.correlation == Approx(-1).epsilon(1e-14));
}

TEST_CASE("of noise one series in two hundred seems to settle, also if it remembers the value before",
          "[settling]") {
  const auto settles = [](const std::vector<double>& values) {
    return settling_of(values).probability < significance;
  };
  for (const std::size_t count : {17, 72})
    for (const Series& noise : kinds_of_noise())
      CHECK(called(count, noise, settles) <= at_most(significance));
}
