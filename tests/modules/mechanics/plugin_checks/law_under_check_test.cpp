#include "law_under_check.hpp"

#include "faulty_law.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::plugin_checks;

TEST_CASE("a measured value passes up to its bound", "[law_under_check]") {
  CHECK(bounded("a", 0.5, 0.5).verdict == Check::Verdict::passed);
  CHECK(bounded("a", 0.51, 0.5).verdict == Check::Verdict::failed);
  CHECK(bounded("a", std::numeric_limits<double>::quiet_NaN(), 0.5).verdict == Check::Verdict::failed);
}

// t = π/√(k/m − (γ/2m)²) of masses m_1 and 1.5^D m_1.
TEST_CASE("closed forms are those of the checked pair", "[law_under_check]") {
  for (const int dimension : {2, 3}) {
    const ConfiguredLaw law(faulty(none), dimension, no_bounds, no_bounds);
    const double r = checked_pair.radius, share = std::pow(1.5, dimension) / (1 + std::pow(1.5, dimension));
    const double first = checked_pair.density * std::numbers::pi * r * r * (dimension == 2 ? 1 : 4 * r / 3);
    const double mass = first * share, decay = 0.5 / mass;
    const double time = std::numbers::pi / std::sqrt(5000 / mass - decay * decay);
    CHECK(contact_time_of(law, checked_pair, dimension) == Approx(time).epsilon(1e-13));
    CHECK(closed_form(law, checked_pair, dimension, "restitution").value() ==
          Approx(std::exp(-decay * time)).epsilon(1e-13));
    CHECK_FALSE(closed_form(law, checked_pair, dimension, "colour"));
  }
}
