#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

#include <scree/plugin/roots.hpp>

using namespace scree;

namespace {

// Largest relative errors of 1/√x and √x over the exponents [low, high].
void check_roots(int low, int high) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(low, high);
  double inverse = 0, root = 0, fourth = 0;
  for (int k = 0; k < 200000; ++k) {
    const double x = std::exp2(exponent(random));
    const long double exact = std::sqrt((long double)(x));
    const Root<double> r = root_of(x);
    CHECK(r.inverse == inverse_sqrt(x));
    inverse = std::max(inverse, double(std::abs(r.inverse * exact - 1)));
    root = std::max(root, double(std::abs(r.value / exact - 1)));
    fourth = std::max(fourth, double(std::abs(inverse_fourth_root(x) * std::sqrt(exact) - 1)));
  }
  const double unit = std::numeric_limits<double>::epsilon();
  CHECK(inverse < 1.5 * unit);
  CHECK(root < unit);
  CHECK(fourth < 2 * unit);
}

}  // namespace

TEST_CASE("roots are correct to the last place over the whole range") { check_roots(-1000, 1000); }

TEST_CASE("the root of zero is zero, and its reciprocal finite") {
  CHECK(root_of(0.0).value == 0);
  CHECK(std::isfinite(root_of(0.0).inverse));
  CHECK(std::isfinite(inverse_fourth_root(0.0)));
  // For subnormal numbers the guess is inaccurate, but finite.
  CHECK(std::isfinite(root_of(std::numeric_limits<double>::denorm_min()).inverse));
}
