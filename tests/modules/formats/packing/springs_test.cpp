#include "packing_support.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/packing/springs.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using scree::Vec3;

namespace {

std::string entries(const std::string& timestep, const std::string& columns, const std::string& rows) {
  return "ITEM: TIMESTEP\n" + timestep + "\nITEM: NUMBER OF ENTRIES\n" +
         std::to_string(std::count(rows.begin(), rows.end(), '\n')) +
         "\nITEM: BOX BOUNDS ff ff ff\n-1 3\n0 2\n0 1e1\nITEM: ENTRIES " + columns + "\n" + rows;
}

std::string refusal_of_springs(const std::string& text, const SpringOptions& options = {}) {
  return error_of([&] { parse_springs(text, "p", options); });
}

const std::vector<std::string> named = {"a", "-", "b", "spring_x", "spring_y", "spring_z"};

}  // namespace

TEST_CASE("springs of pairs are read from a frame of a dump, by names of columns or their order",
          "[packing]") {
  const std::string text =
      entries("5", "c_1[1] c_1[3] c_1[2] c_2[1] c_2[2] c_2[3] ", "7 0 9 1 2 3\n9 0 11 4 5 6\n") +
      entries("6", "c_1[1] c_1[3] c_1[2] c_2[1] c_2[2] c_2[3] ", "7 0 9 -2 0 1e-3\n");
  SpringOptions options{.columns = named};
  std::vector<Spring> springs = parse_springs(text, "p", options);
  REQUIRE(springs.size() == 1);
  CHECK(springs[0].a == 7);
  CHECK(springs[0].b == 9);
  CHECK(springs[0].displacement == Vec3{{-2, 0, 1e-3}});
  options.timestep = 5;
  options.factor = -0.5;
  springs = parse_springs(text, "p", options);
  REQUIRE(springs.size() == 2);
  CHECK(springs[1].displacement == Vec3{{-2, -2.5, -3}});
  // dump_modify of LAMMPS can name the columns; two dimensions have no z.
  const std::string planar = entries("5", "spring_y b a spring_x other", "1 2 3 4 x\n");
  springs = parse_springs(planar, "p", {.dimension = 2});
  REQUIRE(springs.size() == 1);
  CHECK(springs[0].a == 3);
  CHECK(springs[0].displacement == Vec3{{4, 1, 0}});
}

TEST_CASE("a dump of pairs that cannot be springs is refused with its line", "[packing]") {
  const SpringOptions options{.columns = named};
  const auto rows = [&](const std::string& text) {
    return refusal_of_springs(entries("5", "1 2 3 4 5 6", text), options);
  };
  CHECK_THAT(rows("7 0 9 1 2\n"), Contains("p:10:1: 5 words under 6 columns; "));
  CHECK_THAT(rows("7 0 9 1 2 nan\n"), Contains("p:10:11: "));
  CHECK_THAT(rows("7 0 7.5 1 2 3\n"), Contains("p:10:5: "));
  CHECK_THAT(rows("7 0 -9 1 2 3\n"), Contains("p:10:5: "));
  CHECK_THAT(rows("7 0 7 1 2 3\n"), Contains("body 7 is paired with itself"));
  CHECK_THAT(rows("7 0 9 1 2 3\n9 0 7 1 2 3\n"),
             Contains("p:11:1: the pair of bodies 9 and 7 stands in line 10 too; "));
  CHECK_THAT(refusal_of_springs(entries("5", "c_1[1] c_1[2]", "7 9\n")),
             Contains("no column has the name 'a'; name"));
  CHECK_THAT(refusal_of_springs(entries("5", "a a b spring_x spring_y spring_z", "")),
             Contains("more than one column has the name 'a'"));
  CHECK_THAT(refusal_of_springs(entries("5", "1 2 3", ""), {.columns = {"a", "b", "force"}}),
             Contains("there is no column 'force' to read"));
  CHECK_THAT(refusal_of_springs(entries("5", "1 2 3", ""), {.timestep = 4}), Contains("the nearest is 5"));
  CHECK_THAT(refusal_of_springs("ITEM: TIMESTEP\n1\nITEM: ATOMS id x\n1 0\n", options),
             Contains("the dump has atoms and no pairs; give the output of dump local"));
  // A frame that is cut off, in its entries or its head.
  std::string cut = entries("5", "1 2 3 4 5 6", "7 0 9 1 2 3\n9 0 8 1 2 3\n");
  cut.resize(cut.rfind("9 0 8"));
  CHECK_THAT(refusal_of_springs(cut, options), Contains("the frame has 1 of 2 entries; complete the file"));
  CHECK_THAT(refusal_of_springs(entries("5", "1 2 3 4 5 6", "") + "ITEM: TIMESTEP\n6\n", options),
             Contains("the frame has 0 of -1 entries"));
  CHECK_THAT(refusal_of_springs("a b\n", options), Contains("not a text dump"));
  CHECK_THAT(refusal_of_springs("ITEM: UNITS\nlj\n" + entries("5", "a", ""), options), Contains("units"));
}
