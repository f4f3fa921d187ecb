#include "material_types.hpp"

#include "packing_support.hpp"

#include <string>

#include <catch2/catch.hpp>

#include <scree/packing/lammps.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
TEST_CASE("materials become types and types materials", "[packing]") {
  Packing packing = awkward_packing(3, 3);
  packing.time = 0.0;
  packing.bodies[0].material = "steel";
  packing.bodies[1].material = "glass";
  packing.bodies[2].material = "steel";
  ImportOptions options{.dimension = packing.dimension, .periodic = packing.periodic};
  CHECK(parse_lammps_data(format_lammps_data(packing), "d", options).bodies[1].material == "2");
  options.materials = {"glass", "steel", "cork"};
  const std::string text = format_lammps_data(packing, {.materials = options.materials});
  CHECK_THAT(text, Contains("\n3 atom types\n"));
  CHECK(same_bits(parse_lammps_data(text, "d", options), packing));
  CHECK_THAT(error_of([&] { format_lammps_data(packing, {.materials = {"glass"}}); }),
             Contains("material 'steel' has no type number; "));
  options.materials = {"glass"};
  CHECK_THAT(error_of([&] { parse_lammps_data(text, "d", options); }),
             Contains("type 2 has no material: the list has only 1; "));
}

TEST_CASE("type numbers are kept as they are, and names are numbered in their order", "[packing]") {
  const auto types_of = [](const std::vector<std::string>& names, const std::vector<std::string>& listed) {
    Packing packing = awkward_packing(3, names.size());
    for (std::size_t k = 0; k < names.size(); ++k) packing.bodies[k].material = names[k];
    const MaterialTypes types(packing, listed);
    std::vector<std::int64_t> all = {types.count()};
    for (const Body& body : packing.bodies) all.push_back(types.type(body));
    return all;
  };
  using Numbers = std::vector<std::int64_t>;  // how many types, and that of each body
  CHECK(types_of({"7", "2", ""}, {}) == Numbers{7, 7, 2, 1});
  CHECK(types_of({"steel", "2", "steel"}, {}) == Numbers{2, 1, 2, 1});
  CHECK(types_of({"02", "2", "10001"}, {}) == Numbers{3, 1, 2, 3});  // not type numbers
  CHECK(types_of({"steel", "", "glass"}, {"glass", "cork", "steel"}) == Numbers{3, 3, 1, 1});
}
