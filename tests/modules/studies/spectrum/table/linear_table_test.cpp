#include "table_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE(
    "the linear response is that of short steps and of sticking contacts, unless its table says otherwise",
    "[spectrum]") {
  const spectrum::LinearSettings usual = spectrum::read_spectrum(plan_with_spectrum(driven))->linear;
  CHECK_FALSE(usual.step_of_run);
  CHECK_FALSE(usual.contacts_slide);
  CHECK_FALSE(usual.adaptive);
  CHECK(usual.tolerance == 1e-3);
  CHECK(usual.fewest_contacts == 0);
  const spectrum::LinearSettings own =
      spectrum::read_spectrum(
          plan_with_spectrum(
              driven +
              "[spectrum.linear]\nsliding_contacts = 'slide'\nfewest_contacts = 2\nadaptive = true\n"))
          ->linear;
  CHECK(own.contacts_slide);
  CHECK(own.fewest_contacts == 2);
  CHECK(own.adaptive);
  CHECK_THAT(refused(driven + "[spectrum.linear]\nsliding_contacts = 'glide'\n"),
             Catch::StartsWith("scene.toml:29:20: "));
}
