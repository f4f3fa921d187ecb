#include "faulty_law.hpp"
#include "law_under_check.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::plugin_checks;

namespace {

using Family = Checks (*)(const LawUnderCheck&);

std::string failed_by(Fault fault, Family family, int dimension = 3) {
  const ConfiguredLaw law(faulty(fault), dimension, no_bounds, no_bounds);
  const double time = contact_time_of(law, checked_pair, dimension);
  return failed(family({law, dimension, Passage(dimension, checked_pair, time)}));
}

}  // namespace

TEST_CASE("checks of batches find the mistakes that they are meant for", "[batch_checks]") {
  CHECK_THAT(failed_by(asymmetric, check_symmetries),
             Catch::Contains("force and couple change sign when the bodies change their names"));
  CHECK(failed_by(anisotropic, check_symmetries) == "force and couple rotate with the contact");
  CHECK(failed_by(sideways, check_direction) == "forces are along the normal, or `tangential` is declared");
}

TEST_CASE("a law without a mistake passes the checks of batches", "[batch_checks]") {
  for (const int dimension : {2, 3})
    for (const Family family : {check_symmetries, check_direction, check_parting, check_batches})
      CHECK(failed_by(none, family, dimension) == "");
}
