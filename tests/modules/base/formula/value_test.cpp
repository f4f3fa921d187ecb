#include "formula_support.hpp"

#include <bit>

using namespace scree;
using namespace scree::test;

TEST_CASE("a formula that was encoded as numbers has the same bits", "[formula]") {
  const formula::Formula formula = formula::parse("-p.c^2 / max(p.a, 0.1) + sin(p.b) * 1e-3");
  const std::vector<std::size_t> slots = {4, 1, 2};
  const std::vector<double> values = {0, a, b, 0, c};
  const double straight = formula::value(formula, std::vector<double>{c, a, b});
  const double again = formula::value(formula::decoded(formula::encoded(formula, slots)), values);
  CHECK(std::bit_cast<std::uint64_t>(straight) == std::bit_cast<std::uint64_t>(again));
  CHECK(straight == Approx(-c * c / a + std::sin(b) * 1e-3).epsilon(1e-15));
}
