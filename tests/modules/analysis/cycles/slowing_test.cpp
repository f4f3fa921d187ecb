#include "slowing.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::cycles;

namespace {

constexpr double slowing_round_off = 1e-13, preference = 3;

template <class Strain>
SlowingDown laws_of(std::size_t count, const Strain& strain) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) values.push_back(strain(double(k)));
  return slowing_down(values, slowing_round_off, preference);
}

}  // namespace

// Scales and exponents are searched to 1e-6 or better; the other numbers follow from them.
TEST_CASE("of each law the numbers are found", "[slowing]") {
  using Law = Slowing::Law;
  const Slowing laws[] = {{Law::exponential, 10, 0, 0.3, -0.1},
                          {Law::power_to_limit, 3, -0.4, 0.3, 0.2},
                          {Law::logarithm, 2, 0, 0.1, 0.5},
                          {Law::power, 5, 0.5, -1, 0.2},
                          {Law::exponential_and_line, 6, 0, 0.3, -0.1, 0.002},
                          {Law::power_and_line, 3, -2, 0.3, 0.5, 0.003}};
  for (const Slowing& law : laws) {
    CAPTURE(law_text(law));
    const SlowingDown found = laws_of(100, [&](double k) { return value_of(law, k); });
    const bool has_line = law.slope != 0, has_limit = law.law <= Law::power_to_limit;
    const Slowing& same = has_line ? found.with_line : has_limit ? found.with_limit : found.without_limit;
    CHECK(same.law == law.law);
    CHECK(same.scale == Approx(law.scale).epsilon(1e-3));
    CHECK(same.exponent == Approx(law.exponent).epsilon(1e-3));
    CHECK(same.amplitude == Approx(law.amplitude).epsilon(1e-3));
    CHECK(same.constant == Approx(law.constant).epsilon(1e-3));
    CHECK(same.slope == Approx(law.slope).epsilon(1e-3));
    if (!has_line) CHECK((found.preference > preference) == has_limit);
  }
}

// The last value of the slowest power is 2e-4 from its limit.
TEST_CASE("the limit of a strain that approaches it by a slow power is found", "[slowing]") {
  for (const double power : {0.1, 0.2, 0.3, 0.45, 0.5, 0.7, 1.0}) {
    CAPTURE(power);
    const SlowingDown found = laws_of(72, [&](double k) { return 1e-3 - 3e-4 * std::pow(k + 1, -power); });
    CHECK(found.preference > preference);
    CHECK(found.with_limit.constant == Approx(1e-3).epsilon(1e-6));
    CHECK(found.with_limit.exponent == Approx(-power).epsilon(1e-4));
  }
}

TEST_CASE("a long series has the law of its blocks", "[slowing]") {
  const Slowing law{Slowing::Law::logarithm, 200, 0, 0, 1};
  const Slowing found = laws_of(3000, [&](double k) { return value_of(law, k); }).without_limit;
  // Means over 10 of 200 cycles differ from values in their middle by (10/200)^2/24 = 1e-4.
  CHECK(found.scale == Approx(200).epsilon(1e-3));
  CHECK(found.amplitude == Approx(1).epsilon(1e-3));
}

TEST_CASE("behind a settling part a line goes on straight where less than its strain is left", "[slowing]") {
  // 0.1 exp(-k/5) < 0.001 from k = 5 log(100) = 23.03 on.
  for (const double sign : {1, -1}) {
    const SlowingDown found =
        laws_of(200, [&](double k) { return 1e-3 * k + sign * 0.1 * std::exp(-k / 5); });
    CHECK(found.straight);
    CHECK(found.straight_from == 24);
    CHECK(found.with_line.slope == Approx(1e-3).epsilon(1e-3));
  }
  CHECK_FALSE(laws_of(200, [](double k) { return 0.1 * std::exp(-k / 5); }).straight);
  // 24 values before and 31 after: one too few for a line.
  CHECK_FALSE(laws_of(55, [](double k) { return 1e-3 * k + 0.1 * std::exp(-k / 5); }).straight);
  CHECK(laws_of(56, [](double k) { return 1e-3 * k + 0.1 * std::exp(-k / 5); }).straight);
}

TEST_CASE("laws are printed with their numbers", "[slowing]") {
  using Law = Slowing::Law;
  CHECK(law_text({Law::logarithm, 2, 0, 0, 1e-6}) == "1.000e-06 log(1 + k/2)");
  CHECK(law_text({Law::power_to_limit, 3, -0.4, 0.3, 0.2}) == "0.3 + 2.000e-01 (1 + k/3)^-0.4");
  CHECK(law_text({Law::exponential_and_line, 6, 0, 0.3, -0.1, 0.002}) ==
        "-1.000e-01 exp(-k/6) + 2.000e-03 k");
}
