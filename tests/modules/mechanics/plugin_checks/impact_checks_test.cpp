#include "faulty_law.hpp"
#include "law_under_check.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::plugin_checks;

TEST_CASE("impacts of a spring and dashpot close their balances and have its closed forms",
          "[impact_checks]") {
  for (const int dimension : {2, 3}) {
    const Checks checks = check_impacts(faulty(none), checked_pair, dimension);
    CHECK(checks.size() == 5);
    CHECK(failed(checks) == "");
  }
}

TEST_CASE("impacts show a wrong balance and wrong closed forms, each alone", "[impact_checks]") {
  const auto failed_by = [](Fault fault) { return failed(check_impacts(faulty(fault), checked_pair, 2)); };
  CHECK(failed_by(unbalanced) == "the energy balance of impacts closes as the step falls");
  CHECK(failed_by(restitution) == "the closed form restitution is that of a head-on impact");
  CHECK(failed_by(duration) == "the closed form contact_time is that of a head-on impact");
  CHECK_THAT(failed_by(creates_energy), Catch::Contains("no energy is created"));
}
