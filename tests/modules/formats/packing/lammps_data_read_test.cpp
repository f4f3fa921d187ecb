#include "packing_support.hpp"

#include <string>

#include <catch2/catch.hpp>

#include <scree/packing/lammps.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const std::string header =
    "title with 9 atoms\n\n2 atoms\n1 atom types\n0 1 xlo xhi\n0 2 ylo yhi\n0 3 zlo zhi\n";
const std::string atoms = "\nAtoms # sphere\n\n1 1 0.5 2500 0.1 0.2 0.3\n2 1 0.25 2500 0.5 0.5 0.5\n";

std::string refusal_of_data(const std::string& text, const ImportOptions& options = {}) {
  return error_of([&] { parse_lammps_data(text, "d", options); });
}

}  // namespace

TEST_CASE("data files of LAMMPS and LIGGGHTS are read in their variants", "[packing]") {
  const Packing packing = parse_lammps_data(
      "title\n# 7 atoms\n 2 atoms # two\n2 atom types\n0 bonds\n3 extra bond per atom\n0 1 xlo xhi\n-1 2 ylo "
      "yhi\n"
      "0 0 0 xy xz yz\n\nMasses\n\n1 5\n2 5\n\nPair Coeffs # gran\n\n1\n2\nAtoms\n\n"
      "5 2 0.5 2500 0.1 0.2 0.3 0 -1 2 # far\n2 1 .25 +2.5e3 0.5 0.5 -.25 0 0 0\n\nVelocities\n\n"
      "2 1 2 3 4 5 6\n5 0 0 0 0 0 1\n",
      "d");
  REQUIRE(packing.bodies.size() == 2);
  CHECK(packing.bodies[0].id == 5);
  CHECK(packing.bodies[0].material == "2");
  CHECK(packing.bodies[0].radius == 0.25);
  CHECK(packing.bodies[0].spin == scree::Vec3{{0.0, 0.0, 1.0}});
  CHECK(packing.bodies[1].density == 2500.0);
  CHECK(packing.bodies[1].position == scree::Vec3{{0.5, 0.5, -0.25}});
  CHECK(packing.bodies[1].velocity == scree::Vec3{{1.0, 2.0, 3.0}});
  CHECK(packing.bounds->lower == scree::Vec3{{0.0, -1.0, -0.5}});  // z keeps the box that read_data assumes
  CHECK(packing.bounds->upper == scree::Vec3{{1.0, 2.0, 0.5}});
}

TEST_CASE("data file errors name the position and the cure", "[packing]") {
  CHECK(refusal_of_data(header + atoms).empty());
  CHECK_THAT(refusal_of_data(""), Contains("the file is empty; "));
  CHECK_THAT(refusal_of_data("title\n"), Contains("no section Atoms; "));
  CHECK_THAT(refusal_of_data("title\n\nAtoms\n\n"),
             StartsWith("d:3:1: the header has no number of atoms before 'Atoms'; "));
  CHECK_THAT(refusal_of_data(header), Contains("no section Atoms; "));
  CHECK_THAT(refusal_of_data("t\n1e18 atoms\n"),
             StartsWith("d:2:1: number of atoms '1e18' is not an integer; "));
  CHECK_THAT(refusal_of_data("t\n-4 atoms\n"), StartsWith("d:2:1: number of atoms '-4' is not positive; "));
  CHECK_THAT(refusal_of_data("t\n1000000000000000000 atoms\n" + atoms),
             StartsWith("d:7:1: section Atoms ends after 2 of 1"));
  CHECK_THAT(refusal_of_data("t\n3 atoms\n" + atoms),
             StartsWith("d:7:1: section Atoms ends after 2 of 3 lines; "));
  CHECK_THAT(refusal_of_data("t\n1 atoms\n" + atoms),
             StartsWith("d:7:1: the header gives 1 line, and section Atoms has more; "));
  CHECK_THAT(refusal_of_data("t\n1 0 xlo xhi\n"), StartsWith("d:2:1: xlo is not below xhi; "));
  CHECK_THAT(refusal_of_data("t\n0 a xlo xhi\n"), StartsWith("d:2:3: xhi 'a' is not a number; "));
  CHECK_THAT(refusal_of_data("t\n0 0.1 0 xy xz yz\n"), StartsWith("d:2:1: the box is tilted; "));
  CHECK_THAT(refusal_of_data("t\n4 bonds\n"), StartsWith("d:2:1: the file has bonds; "));
  CHECK_THAT(refusal_of_data(header + atoms + "\nBonds\n\n1 1 1 2\n"), Contains("section Bonds; "));
  CHECK_THAT(refusal_of_data(header + "\nAtom\n\n"),
             StartsWith("d:9:1: ") && Contains("did you mean 'Atoms'?"));
  CHECK_THAT(refusal_of_data(header + "\nAtoms # hybrid\n\n"),
             StartsWith("d:9:9: the atom style is 'hybrid'; "));
  CHECK_THAT(refusal_of_data(header + atoms + atoms),
             StartsWith("d:14:1: there is a second section Atoms; "));
  CHECK_THAT(refusal_of_data("\x7f\x45LF\x02\n\x01\xff\n"),
             StartsWith("d:2:1: ") && Contains("'\\x01\\xff'"));
  CHECK_THAT(refusal_of_data(std::string("t\n2 at\0ms\n", 10)), StartsWith("d:2:5: not a text file"));
}

TEST_CASE("errors within a section of a data file name the word", "[packing]") {
  const auto atom = [](const std::string& line) {
    return refusal_of_data("t\n1 atoms\n\nAtoms\n\n" + line + "\n");
  };
  CHECK(atom("1 1 0.5 2500 0 0 0").empty());
  CHECK_THAT(atom("1 1 0.5 2500 0 0"), StartsWith("d:6:1: 6 words instead of"));
  CHECK_THAT(atom("1 1 -0.5 2500 0 0 0"), StartsWith("d:6:5: diameter '-0.5' is not positive; "));
  CHECK_THAT(atom("1 1 0 2500 0 0 0"), StartsWith("d:6:5: diameter '0' is not positive; "));
  CHECK_THAT(atom("1 1 5e-324 2500 0 0 0"), StartsWith("d:6:5: half the diameter is 0"));
  CHECK_THAT(atom("1 1 0.5 0 0 0 0"), StartsWith("d:6:9: density '0' is not positive; "));
  CHECK_THAT(atom("1 1 0.5 2500 nan 0 0"), StartsWith("d:6:14: x 'nan' is not finite; "));
  CHECK_THAT(atom("1 1 0.5 2500 0 -inf 0"), StartsWith("d:6:16: y '-inf' is not finite; "));
  CHECK_THAT(atom("1 1 0.5 2500 0 0 q"), StartsWith("d:6:18: z 'q' is not a number; "));
  CHECK_THAT(atom("0 1 0.5 2500 0 0 0"), StartsWith("d:6:1: id '0' is not positive; "));
  CHECK_THAT(atom("1 a 0.5 2500 0 0 0"), StartsWith("d:6:3: type 'a' is not an integer; "));
  CHECK_THAT(atom("1 1 0.5 2500 0 0 0 0 0.5 0"), StartsWith("d:6:22: image flag '0.5'"));
  CHECK_THAT(refusal_of_data("t\n2 atoms\n\nAtoms\n\n1 1 1 1 0 0 0\n1 1 1 1 5 0 0\n"),
             StartsWith("d:7:1: id 1 is used twice; "));
  CHECK_THAT(refusal_of_data(header + atoms, {.dimension = 2}),
             StartsWith("d:11:22: z '0.3' is not 0 in two dimensions; "));
  const std::string velocities = header + atoms + "\nVelocities\n\n";
  CHECK_THAT(refusal_of_data(velocities + "1 0 0 0 0 0 0\n"),
             Contains("section Velocities ends after 1 of 2 lines; "));
  CHECK_THAT(refusal_of_data(velocities + "1 0 0 0\n"), StartsWith("d:16:1: 4 words instead of"));
  CHECK_THAT(refusal_of_data(velocities + "3 0 0 0 0 0 0\n"), StartsWith("d:16:1: there is no atom 3; "));
  CHECK_THAT(refusal_of_data(velocities + "1 0 0 0 0 0 0\n1 0 0 0 0 0 0\n"),
             Contains("id 1 was used before, in line 16; "));
  CHECK_THAT(refusal_of_data(header + "\nVelocities\n\n"), Contains("Velocities come before Atoms; "));
}

TEST_CASE("a data file in other units than SI is refused, as its title tells", "[packing]") {
  const auto titled = [](const std::string& title) {
    return error_of([&] {
      parse_lammps_data(title +
                            "\n\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms\n\n"
                            "1 1 0.1 2500 0.5 0.5 0.5\n",
                        "packing.data", {});
    });
  };
  CHECK(titled("LAMMPS data file via write_data, version 2 Aug 2023, timestep = 100, units = si").empty());
  CHECK(titled("grains").empty());
  CHECK(titled("LAMMPS data file, timestep = 100, units = lj") ==
        "packing.data:1:43: the file is in units 'lj'; write it with units si");
}
