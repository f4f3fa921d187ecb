#include "faulty_law.hpp"
#include "law_under_check.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::plugin_checks;

TEST_CASE("derivatives that are a thousandth too large are seen", "[derivative_checks]") {
  for (const int dimension : {2, 3})
    for (const Fault fault : {none, derivative}) {
      CAPTURE(dimension, fault);
      const ConfiguredLaw law(faulty(fault), dimension, no_bounds, no_bounds);
      const double time = contact_time_of(law, checked_pair, dimension);
      const Checks checks = check_derivatives({law, dimension, Passage(dimension, checked_pair, time)});
      CHECK(failed(checks) == (fault == derivative ? "derivatives agree with finite differences" : ""));
    }
}
