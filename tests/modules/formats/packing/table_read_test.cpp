#include "packing_support.hpp"

#include <catch2/catch.hpp>

#include <scree/packing/import.hpp>
#include <scree/packing/other_codes.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using scree::Vec3;

namespace {

Packing read_table(const std::string& text, const ImportOptions& options = {}) {
  return parse_packing(text, "t.txt", options);
}

std::string refusal_of_table(const std::string& text, const ImportOptions& options = {}) {
  return error_of([&] { read_table(text, options); });
}

ImportOptions with_columns(std::vector<std::string> columns) {
  ImportOptions options;
  options.columns = std::move(columns);
  return options;
}

}  // namespace

TEST_CASE("a table of YADE has the columns of its first line", "[packing]") {
  const Packing plain = read_table("#format x_y_z_r\n# a comment\n0.5\t1\t2\t0.1\n-1.5\t0\t0\t0.2\n");
  CHECK(plain.format == "a table of YADE: x y z r");
  REQUIRE(plain.bodies.size() == 2);
  CHECK(plain.bodies[0].position == Vec3{{0.5, 1, 2}});
  CHECK(plain.bodies[1].position == Vec3{{-1.5, 0, 0}});
  CHECK(plain.bodies[1].radius == 0.2);
  CHECK_FALSE(plain.own_ids);

  ImportOptions options;
  options.materials = {"glass", "steel"};
  const Packing materials = read_table("#format id_x_y_z_r_matId\n0 0.5 1 2 0.1 1\n7 3 1 2 0.1 0\n", options);
  CHECK(materials.format == "a table of YADE: id + 1 x y z r matId");
  CHECK(materials.bodies[0].material == "steel");
  CHECK(materials.bodies[1].material == "glass");
  CHECK(materials.bodies[0].id == 1);
  CHECK(materials.bodies[1].id == 8);
  CHECK(materials.own_ids);
  CHECK(refusal_of_table("#format x_y_z_r_matId\n0 1 2 0.1 2\n", options) ==
        "t.txt:2:11: matId 2 has no material: counted from 0, the scene has only 2; "
        "add a [[material]] for each number of the file, or leave the column out");
  CHECK_THAT(refusal_of_table("#format x_y_z_r_attrs\n0 1 2 0.1 2\n"),
             StartsWith("t.txt:1:17: column 'attrs' of YADE is not known; name the columns with the key "));
}

TEST_CASE("tables of numbers alone are x y r, x y z r, or a SpherePack of YADE", "[packing]") {
  const Packing flat = read_table("0.5 1 0.1\n2 3 0.2\n");
  CHECK(flat.format == "a table: x y r");
  CHECK(flat.dimension == 2);
  CHECK(flat.bodies[1].position == Vec3{{2, 3, 0}});
  CHECK(flat.bodies[1].radius == 0.2);
  const Packing spheres = read_table("\n# made by hand\n0.5 1 2 0.1\n2 3 4 0.2\n");
  CHECK(spheres.format == "a table: x y z r");
  CHECK(spheres.dimension == 3);
  CHECK(spheres.bodies[1].position == Vec3{{2, 3, 4}});
  CHECK(spheres.bodies[1].radius == 0.2);
  const Packing pack = read_table("##PERIODIC:: 1 2 3\n0.5 1 2 0.1 -1\n0.5 1 1 0.2 -1\n");
  CHECK(pack.format == "a SpherePack of YADE: x y z r (without clump), periodic");
  CHECK(pack.periodic == std::array{true, true, true});
  CHECK(pack.bounds->upper == Vec3{{1, 2, 3}});
}

TEST_CASE("a table that fits two formats is refused with the key that decides", "[packing]") {
  CHECK_THAT(
      refusal_of_table("1 0.5 1 0.1\n2 0.7 3 0.2\n"),
      StartsWith("t.txt:1:1: the table may have the columns x y z r or id x y r; name its columns with the "
                 "key 'columns' of [particles], such as"));
  CHECK(read_table("1 0.5 1 0.1\n2 0.7 3 0.2\n", with_columns({"id", "x", "y", "r"})).bodies[1].position ==
        Vec3{{0.7, 3, 0}});
  CHECK(read_table("1 0.5 1 0.1\n2 0.7 3 0.2\n", with_columns({"x", "y", "z", "r"})).bodies[1].position ==
        Vec3{{2, 0.7, 3}});
  CHECK_THAT(refusal_of_table("0.5 1 2 0.1 0\n"),
             Contains("may be the clump of a SpherePack of YADE or a material; "));
  CHECK_THAT(refusal_of_table("0.5 1 2 0.1 0 7\n"), Contains("nothing says what the 6 columns are; "));
  CHECK_THAT(refusal_of_table("0.5 1 0.1\n", with_columns({"x", "y"})), Contains("the key 'columns' lacks"));
  CHECK_THAT(refusal_of_table("0.5 1 0.1\n", with_columns({"x", "y", "r", "rr"})),
             Contains("there is no column 'rr' to read; "));
}

TEST_CASE("a table with names is read by them, and says which columns it leaves out", "[packing]") {
  const Packing packing = read_table(
      "Radius[m] PosX[m] PosY[m] PosZ[m] VelX[m/s] Coordination\n"
      "0.1 1 2 3 -4 6\n0.2 5 6 7 8 0\n");
  CHECK(packing.format == "a table: Radius PosX PosY PosZ VelX (without Coordination)");
  CHECK(packing.bodies[0].position == Vec3{{1, 2, 3}});
  CHECK(packing.bodies[0].velocity == Vec3{{-4, 0, 0}});
  CHECK(packing.bodies[1].radius == 0.2);
  // In a comment, and in two dimensions.
  const Packing comment = read_table("# x y d\n1 2 0.2\n");
  CHECK(comment.dimension == 2);
  CHECK(comment.bodies[0].radius == 0.1);
  CHECK_THAT(refusal_of_table("Radius[mm] PosX[m] PosY[m]\n1 2 3\n"),
             StartsWith("t.txt:1:1: column r has the unit '[mm]'; convert its numbers and write [m]"));
  CHECK_THAT(refusal_of_table("x y r radius\n1 2 3 3\n"),
             Contains("columns r and radius are the same quantity; "));
  CHECK_THAT(refusal_of_table("x y z r\n1 2 3\n"), StartsWith("t.txt:2:1: 3 words under 4 columns; "));
  CHECK_THAT(refusal_of_table("x y z r\n"), Contains("the table has no body; "));
}
