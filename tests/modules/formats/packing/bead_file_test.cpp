#include "packing_support.hpp"

#include <catch2/catch.hpp>

#include <scree/packing/bead_file.hpp>
#include <scree/packing/import.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::string refusal(const std::string& text) {
  return error_of([&] { parse_beads(text, "b.txt"); });
}

}  // namespace

TEST_CASE("a bead list is periodic along x and z between walls at y = 0 and y = H", "[packing]") {
  const Packing packing =
      parse_beads("2 0.01 0.0125\n0.001 0.002 0.003 0.0004\n5e-3 6e-3 7e-3 3e-4\n", "b.txt");
  REQUIRE(packing.bodies.size() == 2);
  CHECK(packing.bounds->lower == scree::Vec3{});
  CHECK(packing.bounds->upper == scree::Vec3{{0.01, 0.0125, 0.01}});
  CHECK(packing.periodic == std::array{true, false, true});
  CHECK(packing.bodies[1].id == 2);
  CHECK(packing.bodies[1].position == scree::Vec3{{5e-3, 6e-3, 7e-3}});
  CHECK(packing.bodies[1].radius == 3e-4);
}

TEST_CASE("bead list errors name the position and the cure", "[packing]") {
  CHECK_THAT(refusal(""), Contains("the file is empty; "));
  CHECK_THAT(refusal("2 1\n"), StartsWith("b.txt:1:1: 2 words instead of 'N L H'; "));
  CHECK_THAT(refusal("-2 1 1\n"), StartsWith("b.txt:1:1: number of beads '-2'"));
  CHECK_THAT(refusal("1 0 1\n"), StartsWith("b.txt:1:3: period '0' is not positive; "));
  CHECK_THAT(refusal("1 1 1\n0 0 0\n"), StartsWith("b.txt:2:1: 3 words"));
  CHECK_THAT(refusal("1 1 1\n0 0 0 -1\n"), StartsWith("b.txt:2:7: radius '-1'"));
  CHECK_THAT(refusal("2 1 1\n0 0 0 1\n"), Contains("the first line gives 2 beads, the file has 1; "));
  CHECK_THAT(refusal("1000000000000000000 1 1\n0 0 0 1\n"),
             Contains("the first line gives 1000000000000000000 beads"));
}

TEST_CASE("the format of a file is detected from its first lines", "[packing]") {
  CHECK(detect_format("ITEM: TIMESTEP\n0\n", "a") == FileFormat::lammps_dump);
  CHECK(detect_format("title\n\n 3 atoms\n", "a") == FileFormat::lammps_data);
  CHECK(detect_format("# note\nx,y,radius\n", "a") == FileFormat::csv);
  CHECK(detect_format("1 0.5 0.5\n", "a") == FileFormat::beads);
  CHECK_THAT(error_of([] { detect_format("hello\n", "a"); }),
             StartsWith("a:1:1: ") && Contains("give CSV with a header line"));
  CHECK_THAT(error_of([] { detect_format("", "a"); }), Contains("the file is empty"));
  CHECK(file_format("lammps_dump") == FileFormat::lammps_dump);
  CHECK_THAT(error_of([] { file_format("lammps-data"); }), Contains("did you mean 'lammps_data'?"));
}

TEST_CASE("a byte order mark in front of a file of any format is passed over", "[packing]") {
  for (const std::string text :
       {"x,y,z,radius\n0.5,0.5,0.5,0.1\n", "1 1 1\n0.5 0.5 0.5 0.1\n",
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
        "ITEM: ATOMS id x y z radius\n1 0.5 0.5 0.5 0.1\n"})
    CHECK(parse_packing("\xef\xbb\xbf" + text, "packing").bodies.size() == 1);
}

TEST_CASE("columns separated by semicolons are refused with what to write", "[packing]") {
  CHECK(error_of([] {
          parse_packing("x;y;z;radius\n0,5;0,5;0,5;0,1\n", "packing");
        }).starts_with("packing:1:"));
  CHECK(error_of([] { parse_packing("x;y;z;radius\n", "packing"); }) ==
        "packing:1:1: the format of the file is not recognised; "
        "separate the columns of a CSV file by commas, and write decimal points");
}
