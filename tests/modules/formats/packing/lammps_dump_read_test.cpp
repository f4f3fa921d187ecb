#include "packing_support.hpp"

#include <string>

#include <catch2/catch.hpp>

#include <scree/packing/lammps.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using scree::Vec3;

namespace {

std::string frame(const std::string& timestep, const std::string& columns, const std::string& rows,
                  const std::string& count = "2") {
  return "ITEM: TIMESTEP\n" + timestep + "\nITEM: NUMBER OF ATOMS\n" + count +
         "\nITEM: BOX BOUNDS pp ff pp\n-1 3\n0 2\n0 1e1\nITEM: ATOMS " + columns + "\n" + rows;
}

std::string refusal_of_dump(const std::string& text, const ImportOptions& options = {}) {
  return error_of([&] { parse_dump(text, options); });
}

}  // namespace

TEST_CASE("dump columns come in any order among others", "[packing]") {
  const Packing packing = parse_dump(frame("5", "fx radius z c_1[2] y id x type vy omegax mass ",
                                           "nan 0.5 1 - 2 9 3 2 4 5 6\nnan 0.25 1 - 1 8 1 1 0 0 7\n"));
  REQUIRE(packing.bodies.size() == 2);
  const Body& body = packing.bodies[0];
  CHECK(body.id == 9);
  CHECK(body.material == "2");
  CHECK(body.radius == 0.5);
  CHECK(body.position == Vec3{{3.0, 2.0, 1.0}});
  CHECK(body.velocity == Vec3{{0.0, 4.0, 0.0}});
  CHECK(body.spin == Vec3{{5.0, 0.0, 0.0}});
  CHECK(body.mass == 6.0);
  CHECK(packing.periodic == std::array{true, false, true});
  CHECK(packing.bounds->lower == Vec3{{-1.0, 0.0, 0.0}});
  CHECK(packing.bounds->upper == Vec3{{3.0, 2.0, 10.0}});
}

TEST_CASE("scaled coordinates are fractions of the box", "[packing]") {
  const Packing packing = parse_dump(frame("0", "id xs ys zs diameter", "1 0.25 0.5 0.75 1\n2 0 0 0 1\n"));
  CHECK(packing.bodies[0].position == Vec3{{0.0, 1.0, 7.5}});
  CHECK(packing.bodies[0].radius == 0.5);
  CHECK(packing.bodies[1].position == Vec3{{-1.0, 0.0, 0.0}});
}

TEST_CASE("unwrapped coordinates are wrapped into the box along periodic axes", "[packing]") {
  const Packing packing = parse_dump(frame("0", "id xu yu zu radius", "1 11.5 2.5 -0.5 1\n2 3 1 0 1\n"));
  CHECK(packing.bodies[0].position == Vec3{{-0.5, 2.5, 9.5}});
  CHECK(packing.bodies[1].position == Vec3{{3.0, 1.0, 0.0}});
  CHECK(parse_dump(frame("0", "xsu ysu zsu radius", "1.25 0.5 -0.25 1\n0 0 0 1\n")).bodies[0].position ==
        Vec3{{0.0, 1.0, 7.5}});
  CHECK(parse_dump(frame("0", "xu x y z radius", "9 1 1 1 1\n9 2 1 1 1\n")).bodies[1].position[0] == 2.0);
}

TEST_CASE("the last frame of a dump, or that of a given timestep, is read", "[packing]") {
  const std::string text = frame("0", "x y z radius", "1 1 1 1\n2 1 1 1\n") +
                           frame("100", "x y z radius", "1.5 1 1 1\n2 1 1 1\n") +
                           frame("200", "x y z radius", "2.5 1 1 1\n2 1 1 1\n");
  CHECK(parse_dump(text).bodies[0].position[0] == 2.5);
  CHECK(parse_dump(text, {.timestep = 0}).bodies[0].position[0] == 1.0);
  CHECK(parse_dump(text, {.timestep = 100}).bodies[0].position[0] == 1.5);
  CHECK_THAT(refusal_of_dump(text, {.timestep = 130}),
             Contains("there is no timestep 130 in 3 frames; the nearest is 100"));
  const std::string cut = text.substr(0, text.size() - 8);
  CHECK_THAT(refusal_of_dump(cut),
             Contains("cut off after 1 of 2 atoms; ") && Contains("an earlier timestep"));
  CHECK(parse_dump(cut, {.timestep = 100}).bodies[0].position[0] == 1.5);
}

TEST_CASE("units and time precede the timestep of their frame", "[packing]") {
  const std::string columns = "x y z radius";
  const std::string rows = "1 1 1 1\n2 1 1 1\n";
  const std::string text = "ITEM: UNITS\nsi\nITEM: TIME\n0\n" + frame("0", columns, rows) +
                           "ITEM: TIME\n0.25\n" + frame("100", columns, rows);
  CHECK(parse_dump(text).time == 0.25);
  CHECK(parse_dump(text, {.timestep = 0}).time == 0.0);
  CHECK_THAT(refusal_of_dump("ITEM: UNITS\nlj\n" + frame("0", columns, rows)),
             StartsWith("d:2:1: ") && Contains("'lj'"));
}

TEST_CASE("a two-dimensional dump needs no z", "[packing]") {
  const Packing packing = parse_dump(frame("0", "x y radius", "1 1 1\n2 1 1\n"), {.dimension = 2});
  CHECK(packing.dimension == 2);
  CHECK(packing.periodic == std::array{true, false, false});
  CHECK_THAT(refusal_of_dump(frame("0", "x y z radius", "1 1 1 1\n2 1 1 1\n"), {.dimension = 2}),
             StartsWith("d:10:5: z '1' is not 0"));
}

TEST_CASE("dump errors name the position and the cure", "[packing]") {
  const std::string columns = "id x y z radius";
  const std::string rows = "1 1 1 1 1\n2 2 1 1 1\n";
  CHECK(refusal_of_dump(frame("0", columns, rows)).empty());
  CHECK_THAT(refusal_of_dump(""), Contains("the dump is empty; "));
  CHECK_THAT(refusal_of_dump("hello\n"), StartsWith("d:1:1: not a text dump"));
  CHECK_THAT(refusal_of_dump("ITEM: TIMESTEP\n"), Contains("cut off"));
  CHECK_THAT(refusal_of_dump(frame("x", columns, rows)),
             StartsWith("d:2:1: timestep 'x' is not an integer; "));
  CHECK_THAT(refusal_of_dump(frame("0", columns, rows, "-1")), StartsWith("d:4:1: number of atoms '-1'"));
  CHECK_THAT(refusal_of_dump(frame("0", columns, rows, "1000000000000000000")),
             Contains("cut off after 2 of 1000"));
  CHECK_THAT(refusal_of_dump(frame("0", columns, rows, "3")), Contains("cut off after 2 of 3 atoms; "));
  CHECK_THAT(refusal_of_dump(frame("0", columns, rows, "1")),
             StartsWith("d:11:1: the frame header gives 1 atom, and there are more; "));
  CHECK_THAT(refusal_of_dump(frame("0", "id y z radius", rows)),
             StartsWith("d:9:1: there are no positions; "));
  CHECK_THAT(refusal_of_dump(frame("0", "id x y z mass", rows)),
             Contains("neither a column radius nor diameter; "));
  CHECK_THAT(refusal_of_dump(frame("0", columns, "1 1 1 1\n2 2 1 1 1\n")),
             StartsWith("d:10:1: 4 words under 5 columns; "));
  CHECK_THAT(refusal_of_dump(frame("0", columns, "1 1 1 1 -1\n2 2 1 1 1\n")),
             StartsWith("d:10:9: radius '-1'"));
  CHECK_THAT(refusal_of_dump(frame("0", columns, "1 nan 1 1 1\n2 2 1 1 1\n")),
             StartsWith("d:10:3: x 'nan' is not finite; "));
  CHECK_THAT(refusal_of_dump(frame("0", columns, "1 1 1 1 1\n1 2 1 1 1\n")),
             StartsWith("d:11:1: id 1 was used before"));
  CHECK_THAT(refusal_of_dump("ITEM: BOX BOUNDS pp pp pp\n1 0\n"), StartsWith("d:2:1: the upper bound of x"));
  CHECK_THAT(refusal_of_dump("ITEM: BOX BOUNDS xy xz yz pp pp pp\n0 1 0\n"), Contains("the box is tilted; "));
  CHECK_THAT(refusal_of_dump("ITEM: ATOMS x y z radius\n1 1 1 1\n"),
             Contains("the number of atoms or the box is missing"));
  CHECK_THAT(refusal_of_dump("ITEM: NUMBER OF ENTRIES\n1\n"), StartsWith("d:1:1: unknown item"));
}
