#include "repetition.hpp"

#include "noise.hpp"
#include "significance.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/cycles/straight_line.hpp>

using namespace scree::cycles;
using namespace scree::test;

namespace {

std::vector<double> wave(std::size_t count, double period) {
  std::vector<double> values;
  for (std::size_t n = 0; n < count; ++n)
    values.push_back(std::cos(2 * std::numbers::pi * (double(n) + 0.3) / period));
  return values;
}

}  // namespace

TEST_CASE("a wave repeats with its period, and not with a multiple", "[repetition]") {
  for (const std::size_t period : {2, 3, 7, 24}) {
    CAPTURE(period);
    std::vector<double> values = wave(72, double(period));
    for (double& value : values) value = std::round(value * 1e6);  // equal phases have equal ranks
    const Repetition found = best_repetition(values);
    CHECK(found.period == period);
    CHECK(std::isinf(found.f));
    CHECK(found.probability == 0);
  }
}

// The phases have the means 6 and 3: F = 8 1.5^2 over 24/6. Their deviations -3, -2, 2, -1, 1, 1, 0, 2 have
// no correlation of neighbours, so that nothing is taken from the values but the first, without which F is
// larger.
TEST_CASE("F compares the means of phases with the deviations within them", "[repetition]") {
  const Repetition found = best_repetition(std::vector<double>{3, 1, 8, 2, 7, 4, 6, 5});
  CHECK(found.periods == 1);
  CHECK(found.period == 2);
  CHECK(found.f == Approx(4.5).epsilon(1e-14));
  CHECK(found.probability == Approx(tail_of_f(4.5, 1, 4)));
}

TEST_CASE("periods up to a third of the values are tried, but no more than a thousand", "[repetition]") {
  CHECK(best_repetition(wave(30, 10)).periods == 9);
  CHECK(best_repetition(wave(30, 10)).period == 10);
  CHECK(best_repetition(wave(29, 10)).periods == 8);
  CHECK(best_repetition(wave(5, 2)).periods == 0);
}

TEST_CASE("of noise one series in two hundred repeats by chance, also if it remembers the value before",
          "[repetition]") {
  const auto repeats = [](std::vector<double> values) {
    const StraightLine line = robust_line(values);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] -= line.intercept + line.slope * double(k);
    return best_repetition(values).probability < significance;
  };
  for (const std::size_t count : {17, 72})
    for (const Series& noise : kinds_of_noise())
      CHECK(called(count, noise, repeats) <= at_most(significance));
}
