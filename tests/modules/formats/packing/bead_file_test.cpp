#include "packing_support.hpp"

#include <catch2/catch.hpp>

#include <scree/packing/bead_file.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::string refusal_of_beads(const std::string& text) {
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
  CHECK_THAT(refusal_of_beads(""), Contains("the file is empty; "));
  CHECK_THAT(refusal_of_beads("2 1\n"), StartsWith("b.txt:1:1: 2 words instead of 'N L H'; "));
  CHECK_THAT(refusal_of_beads("-2 1 1\n"), StartsWith("b.txt:1:1: number of beads '-2'"));
  CHECK_THAT(refusal_of_beads("1 0 1\n"), StartsWith("b.txt:1:3: period '0' is not positive; "));
  CHECK_THAT(refusal_of_beads("1 1 1\n0 0 0\n"), StartsWith("b.txt:2:1: 3 words"));
  CHECK_THAT(refusal_of_beads("1 1 1\n0 0 0 -1\n"), StartsWith("b.txt:2:7: radius '-1'"));
  CHECK_THAT(refusal_of_beads("2 1 1\n0 0 0 1\n"),
             Contains("the first line gives 2 beads, the file has 1; "));
  CHECK_THAT(refusal_of_beads("1000000000000000000 1 1\n0 0 0 1\n"),
             Contains("the first line gives 1000000000000000000 beads"));
}
