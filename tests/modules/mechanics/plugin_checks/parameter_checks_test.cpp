#include "faulty_law.hpp"
#include "law_under_check.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::plugin_checks;

// The law has a stiffness above 0, a damping of 0 or more, an exponent in a range, and a choice of eleven.
TEST_CASE("a law that is not finite at a limit of a parameter fails by its name", "[parameter_checks]") {
  const Checks sound = check_limits(faulty(none), checked_pair, 3);
  REQUIRE(sound.size() == 1);
  CHECK(sound[0].name == "finite results at the limits of the parameters");
  CHECK(sound[0].verdict == Check::Verdict::passed);
  CHECK_THAT(sound[0].detail, Catch::EndsWith(" tried, 0 refused"));
  const Checks faulted = check_limits(faulty(infinite), checked_pair, 3);
  CHECK(faulted[0].verdict == Check::Verdict::failed);
  CHECK(faulted[0].detail == "not finite with exponent = 0");
}
