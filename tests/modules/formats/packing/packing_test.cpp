#include "packing_support.hpp"

#include <string>

#include <catch2/catch.hpp>

#include <scree/packing/packing.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;

TEST_CASE("an invalid packing is refused with body and field", "[packing]") {
  const auto refusal = [](const Packing& packing) { return error_of([&] { check(packing); }); };
  Packing packing = two(3.0);
  CHECK(refusal(packing).empty());
  packing.bodies[0].id = 3;
  CHECK_THAT(refusal(packing), Contains("body 3: the id is used twice"));
  packing.bodies[0].id = 0;
  CHECK_THAT(refusal(packing), Contains("id is not positive"));
  packing = two(3.0);
  packing.bodies[1].radius = -1.0;
  CHECK_THAT(refusal(packing), Contains("body 3: the radius -1 m"));
  packing = two(std::nan(""));
  CHECK_THAT(refusal(packing), Contains("not finite"));
  packing = two(3.0);
  packing.bodies[0].mass = packing.bodies[0].density = 1.0;
  CHECK_THAT(refusal(packing), Contains("density and mass are both given"));
  packing = two(3.0);
  packing.dimension = 2;
  CHECK(refusal(packing).empty());
  packing.bodies[0].spin[0] = 1.0;
  CHECK_THAT(refusal(packing), Contains("in two dimensions"));
  packing = two(3.0);
  packing.periodic[1] = true;
  CHECK_THAT(refusal(packing), Contains("y is periodic without a finite period"));
  CHECK_THAT(refusal(Packing{}), Contains("no bodies"));
}
