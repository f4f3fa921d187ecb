#include "packing_support.hpp"

#include <string>

#include <catch2/catch.hpp>

#include <scree/packing/lammps.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {}  // namespace

TEST_CASE("a dump keeps every bit", "[packing]") {
  Packing packing = awkward_packing(GENERATE(2, 3));
  CHECK(same_bits(parse_dump(format_lammps_dump(packing), {.dimension = packing.dimension}), packing));
  packing.periodic[2] = false;
  const ImportOptions options{.dimension = packing.dimension, .periodic = packing.periodic};
  CHECK(same_bits(parse_dump(format_lammps_dump(packing), options), packing));
  packing.time = 0.0;
  const std::string text = format_lammps_dump(packing, {.dialect = Dialect::liggghts, .timestep = 12});
  CHECK_THAT(text, StartsWith("ITEM: TIMESTEP\n12\n"));
  CHECK(same_bits(parse_dump(text, options), packing));
}

TEST_CASE("a dump is refused if only some bodies have a density", "[packing]") {
  Packing packing = awkward_packing(3);
  packing.bodies[3].density = unset;
  CHECK_THAT(error_of([&] { format_lammps_dump(packing); }), Contains("49 of 50 bodies have a density"));
  for (Body& body : packing.bodies) body.density = unset;
  CHECK(same_bits(parse_dump(format_lammps_dump(packing)), packing));
}
