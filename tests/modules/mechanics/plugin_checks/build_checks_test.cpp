#include "faulty_law.hpp"
#include "law_under_check.hpp"
#include "scenes.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::plugin_checks;

TEST_CASE("builds of a law for other processors give its bits, in loops that are vectorised",
          "[build_checks]") {
  const Parameters law = test::parameters("linear_spring_dashpot", SCREE_CONTACT_LAW,
                                          {{"normal_stiffness", {5000}}, {"normal_damping", {1}}});
  const auto library = test::host().locate("linear_spring_dashpot", SCREE_CONTACT_LAW);
  for (const int dimension : {2, 3}) {
    const Checks checks = check_levels(law, library, checked_pair, dimension);
    REQUIRE(checks.size() == 1);
    CHECK(failed(checks) == "");
    CHECK(checks[0].detail != "");  // the levels that were compared
  }
  CHECK(failed(check_machine_code(library)) == "");
}

TEST_CASE("a level for which there is no build is left out", "[build_checks]") {
  const auto library = host_of_laws().locate("faulty", SCREE_CONTACT_LAW);
  for (const Check& check : check_machine_code(library)) {
    CHECK(check.verdict == Check::Verdict::skipped);
    CHECK_THAT(check.detail, Catch::Contains("there is no build for it; "));
  }
}
