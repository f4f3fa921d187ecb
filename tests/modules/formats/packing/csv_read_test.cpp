#include "packing_support.hpp"

#include <string>

#include <catch2/catch.hpp>

#include <scree/packing/csv.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::string refusal_of_csv(const std::string& text, const ImportOptions& options = {}) {
  return error_of([&] { parse_csv(text, "a.csv", options); });
}

}  // namespace

TEST_CASE("CSV columns come in any order, with or without units", "[packing]") {
  const Packing packing = parse_csv(
      "# a comment\n\n wz , \"radius [m]\",y[m], x [m] ,z,id\r\n"
      "3,0.5,2,+1,0,7\r\n# between\n1e0, 0.25 ,4,3,5.5,2\n",
      "a.csv");
  REQUIRE(packing.bodies.size() == 2);
  CHECK(packing.dimension == 3);
  CHECK(packing.bodies[0].id == 7);
  CHECK(packing.bodies[0].radius == 0.5);
  CHECK(packing.bodies[0].position == scree::Vec3{{1.0, 2.0, 0.0}});
  CHECK(packing.bodies[0].spin[2] == 3.0);
  CHECK(packing.bodies[1].position == scree::Vec3{{3.0, 4.0, 5.5}});
}

// Names and units are those of probes and scenarios; files of former versions have wx and kg/m3.
TEST_CASE("CSV has the spellings of probes and scenarios, and reads the former ones", "[packing]") {
  Packing packing = awkward_packing(3);
  const std::string text = format_csv(packing);
  CHECK_THAT(text, Contains(",density [kg/m^3],"));
  CHECK_THAT(text, Contains(",spin_x [rad/s],spin_y [rad/s],spin_z [rad/s]\n"));
  for (const std::string density : {"density", "density [kg/m3]", "density [kg/m^3]"})
    for (const std::string spin : {"spin_z", "wz", "wz [rad/s]", "spin_z [rad/s]"}) {
      CAPTURE(density, spin);
      const Body body =
          parse_csv("x,y,radius," + density + "," + spin + "\n1,2,3,4,5\n", "a.csv").bodies.at(0);
      CHECK(body.density == 4);
      CHECK(body.spin[2] == 5);
    }
  CHECK_THAT(refusal_of_csv("x,y,radius,wz,spin_z\n1,2,3,4,4\n"), StartsWith("a.csv:1:15: "));
  CHECK_THAT(refusal_of_csv("x,y,radius,density [g/cm^3]\n1,2,3,4\n"), Contains("write [kg/m^3]"));
}

TEST_CASE("absent CSV columns take their defaults", "[packing]") {
  const Packing packing = parse_csv("x,y,diameter\n1,2,3\n4,5,6\n", "a.csv");
  CHECK(packing.dimension == 2);
  CHECK(packing.bodies[1].id == 2);
  CHECK(packing.bodies[1].radius == 3.0);
  CHECK(packing.bodies[1].material.empty());
  CHECK(std::isnan(packing.bodies[1].density));
  CHECK(packing.bodies[1].velocity == scree::Vec3{});
  CHECK_FALSE(packing.bounds);
  CHECK(parse_csv("x,y,radius\n1,2,3\n", "a.csv", {.dimension = 3}).dimension == 3);
  CHECK(parse_csv("x,y,z,radius\n1,2,0,3\n", "a.csv", {.dimension = 2}).dimension == 2);
}

TEST_CASE("CSV errors name the position and the cure", "[packing]") {
  CHECK_THAT(refusal_of_csv("x,y,radios\n"),
             StartsWith("a.csv:1:5: unknown column 'radios'; did you mean 'radius'?"));
  for (const auto& [symbol, column] :
       {std::pair("r", "radius"), std::pair("R", "radius"), std::pair("d", "diameter"),
        std::pair("m", "mass"), std::pair("rho", "density"), std::pair("velocity_y", "vy")})
    CHECK(refusal_of_csv("x,y," + std::string(symbol) + "\n0,0,1\n") ==
          "a.csv:1:5: unknown column '" + std::string(symbol) + "'; did you mean '" + column + "'?");
  for (const std::string numbers : {"0,0,0.01\n1,1,0.01\n", "# a comment\n-1,2e-3,1\n"})
    CHECK_THAT(
        refusal_of_csv(numbers),
        Contains(
            ":1: there is no header, but numbers; name the columns in the first line, such as 'x,y,z,radius'"));
  CHECK_THAT(refusal_of_csv("x,y,radius [mm]\n"),
             StartsWith("a.csv:1:5: ") && Contains("convert its numbers and write [m]"));
  CHECK_THAT(refusal_of_csv("x,y,radius,x\n"), StartsWith("a.csv:1:12: ") && Contains("twice"));
  CHECK_THAT(refusal_of_csv("x,radius\n"), StartsWith("a.csv:1:1: column x or y is missing; "));
  CHECK_THAT(refusal_of_csv("x,y\n"), Contains("either a column radius or a column diameter; "));
  CHECK_THAT(refusal_of_csv("x,y,radius,diameter\n"),
             Contains("either a column radius or a column diameter; "));
  CHECK_THAT(refusal_of_csv("x;y;radius\n"), Contains("semicolons; "));
  CHECK_THAT(refusal_of_csv(""), Contains("no header; "));
  CHECK_THAT(refusal_of_csv("x,y,radius\n"), Contains("no body"));
  CHECK_THAT(refusal_of_csv("x,y,radius\n1,2\n"), StartsWith("a.csv:2:1: 2 cells under 3 columns; "));
  CHECK_THAT(refusal_of_csv("x,y,radius\n1,abc,1\n"), StartsWith("a.csv:2:3: y 'abc' is not a number; "));
  CHECK_THAT(refusal_of_csv("x,y,radius\n1,2m,1\n"), StartsWith("a.csv:2:3: y '2m' is not a number; "));
  CHECK_THAT(refusal_of_csv("x,y,radius\n1,,1\n"), StartsWith("a.csv:2:3: y '' is not a number; "));
  CHECK_THAT(refusal_of_csv("x,y,radius\n1,2,nan\n"), StartsWith("a.csv:2:5: radius 'nan' is not finite; "));
  CHECK_THAT(refusal_of_csv("x,y,radius\n1,2,-1\n"), StartsWith("a.csv:2:5: radius '-1' is not positive; "));
  CHECK_THAT(refusal_of_csv("x,y,radius\n1,1e999,1\n"),
             StartsWith("a.csv:2:3: ") && Contains("outside the range"));
  CHECK_THAT(refusal_of_csv("id,x,y,radius\n1,0,0,1\n1,3,3,1\n"),
             StartsWith("a.csv:3:1: id 1 was used before, in line 2; "));
  CHECK_THAT(refusal_of_csv("id,x,y,radius\n0,0,0,1\n"), StartsWith("a.csv:2:1: id '0' is not positive; "));
  CHECK_THAT(refusal_of_csv("id,x,y,radius\n1.5,0,0,1\n"), Contains("'1.5' is not an integer; "));
  CHECK_THAT(refusal_of_csv("id,x,y,radius\n99999999999999999999,0,0,1\n"),
             Contains("does not fit into 64 bits; "));
  CHECK_THAT(refusal_of_csv("id,x,y,radius\n1000000000000001,0,0,1\n"),
             StartsWith("a.csv:2:1: id 1000000000000001 is above 1000000000000000; "));
  CHECK_THAT(refusal_of_csv("x,y,radius,mass,density\n0,0,1,1,1\n"),
             Contains("density and mass are both given; "));
  CHECK_THAT(refusal_of_csv("x,y,z,radius\n0,0,1,1\n", {.dimension = 2}),
             StartsWith("a.csv:2:5: z '1' is not 0"));
  CHECK_THAT(refusal_of_csv(std::string("x,y,radius\n1,2\0,1\n", 18)),
             StartsWith("a.csv:2:4: not a text file"));
  CHECK_THAT(refusal_of_csv("\x89PNG\x1a\xff\n"),
             StartsWith("a.csv:1:1: unknown column '\\x89PNG\\x1a\\xff'; "));
}

TEST_CASE("values in the comments of a CSV file are checked", "[packing]") {
  const std::string rest = "x,y,z,radius\n1,2,0,3\n";
  CHECK(parse_csv("# time [s]: 2.5\n# note: whatever\n" + rest, "a.csv").time == 2.5);
  CHECK_THAT(refusal_of_csv("# periodic: x w\n" + rest), StartsWith("a.csv:1:15: 'w' is not an axis; "));
  CHECK_THAT(refusal_of_csv("# periodic: x\n" + rest), StartsWith("a.csv: packing: x is periodic without"));
  CHECK_THAT(refusal_of_csv("# dimension: 4\n" + rest), Contains("neither 2 nor 3"));
  CHECK_THAT(refusal_of_csv("# lower [m]: 0 0 0\n" + rest), Contains("only one of"));
  CHECK_THAT(refusal_of_csv("# lower [m]: 0 0\n" + rest), Contains("2 numbers"));
  CHECK_THAT(refusal_of_csv("# lower [m]: 0 0 0\n# upper [m]: -1 0 0\n" + rest),
             Contains("below the lower one; "));
}
