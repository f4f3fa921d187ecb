#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/packing/exports.hpp>

using namespace scree;
using namespace scree::packing;

namespace {

Packing two_bodies() {
  Packing packing;
  packing.time = 0.25;
  packing.bodies = {{.id = 7,
                     .material = "soft glass",
                     .radius = 0.5,
                     .mass = 2,
                     .position = {{1, 2, 3}},
                     .velocity = {{0.1, 0, 0}}},
                    {.id = 9,
                     .material = "steel",
                     .radius = 0.25,
                     .mass = 3,
                     .position = {{4, 5, 6}},
                     .spin = {{0, 0, -1}}}};
  packing.bounds = Bounds{{{0, 0, 0}}, {{10, 8, 7}}};
  packing.periodic = {true, false, false};
  return packing;
}

}  // namespace

TEST_CASE("extended XYZ has the cell, periodic axes, time and a row for each body") {
  CHECK(
      format_xyz(two_bodies()) ==
      "2\nLattice=\"10 0 0 0 8 0 0 0 7\" Origin=\"0 0 0\" "
      "Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:omega:R:3:mass:R:1:id:I:1 pbc=\"T F F\" Time=0.25 "
      "materials=\"soft_glass steel\"\n"
      "H 1 2 3 0.5 0.1 0 0 0 0 0 2 7\nHe 4 5 6 0.25 0 0 0 0 0 -1 3 9\n");
}

TEST_CASE("extended XYZ without a box has the cell of the bodies, which has a volume in 2D too") {
  Packing packing = two_bodies();
  packing.bounds.reset();
  packing.periodic = {};
  packing.dimension = 2;
  for (Body& b : packing.bodies) b.position[2] = 0;
  CHECK_THAT(format_xyz(packing),
             Catch::Contains("Lattice=\"3.75 0 0 0 3.75 0 0 0 1\" Origin=\"0.5 1.5 0\"") ||
                 Catch::Contains("0 0 0 1\" Origin=\"0.5 1.5"));
}

TEST_CASE("YADE's table has a place and a radius for each body") {
  CHECK(format_yade(two_bodies()) == "#format x_y_z_r\n1\t2\t3\t0.5\n4\t5\t6\t0.25\n");
}
