#include "packing_support.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include <scree/packing/csv.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("CSV keeps every bit", "[packing]") {
  Packing packing = awkward_packing(GENERATE(2, 3));
  CHECK(same_bits(parse_csv(format_csv(packing), "a.csv"), packing));
  packing.bodies[0].material = "glass bead";
  packing.bodies[1].material.clear();
  packing.bodies[1].density = unset;
  packing.bodies[2].density = unset;
  packing.bodies[2].mass = 0.1;
  packing.bounds.reset();
  packing.periodic = {};
  CHECK(same_bits(parse_csv(format_csv(packing), "a.csv"), packing));
}

TEST_CASE("a CSV file is written and read", "[packing]") {
  const auto path = std::filesystem::temp_directory_path() / "scree_packing_csv_test.csv";
  const Packing packing = awkward_packing(3);
  write_csv(packing, path);
  CHECK(same_bits(read_csv(path), packing));
  std::filesystem::remove(path);
  CHECK_THAT(error_of([&] { read_csv(path); }), StartsWith(path.string() + ": there is no such file; "));
  CHECK_THAT(error_of([&] { read_csv(path.parent_path()); }), Contains("is not a regular file; "));
  CHECK_THAT(error_of([&] { write_csv(packing, path / "no" / "folder"); }),
             Contains("cannot be opened for writing; "));
}

TEST_CASE("a material that would break a CSV cell is refused", "[packing]") {
  Packing packing = awkward_packing(3);
  packing.bodies[4].material = "glass, fine";
  CHECK_THAT(error_of([&] { format_csv(packing); }), Contains("'glass, fine'") && Contains("rename it"));
}
