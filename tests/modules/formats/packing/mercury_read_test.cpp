#include "packing_support.hpp"

#include <catch2/catch.hpp>

#include <scree/packing/import.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using scree::Vec3;

namespace {

// As MercuryDPM writes it: a blank at the end of the first line of a frame.
const std::string frames =
    "2 0 0 0 0 1 2 3 \n"
    "0.1 0.2 0.3 1 2 3 0.01 9 9 9 4 5 6 0\n"
    "0.5 0.6 0.7 0 0 0 0.02 9 9 9 0 0 0 1\n"
    "1 0.25 0 0 0 1 2 3 \n"
    "0.4 0.5 0.6 -1 0 0 0.01 0 0 0 0 0 7 1\n";

Packing read_mercury(const std::string& text, const ImportOptions& options = {}) {
  return parse_packing(text, "m.data", options);
}

std::string refusal_of_mercury(const std::string& text, const ImportOptions& options = {}) {
  return error_of([&] { read_mercury(text, options); });
}

}  // namespace

TEST_CASE("a .data file of MercuryDPM has frames, of which the last is taken unless one is named",
          "[packing]") {
  const Packing last = read_mercury(frames);
  CHECK(last.format == "a .data file of MercuryDPM, frame 1 of 0 to 1, t = 0.25 s");
  REQUIRE(last.bodies.size() == 1);
  CHECK(last.time == 0.25);
  CHECK(last.bounds->upper == Vec3{{1, 2, 3}});
  ImportOptions options;
  options.timestep = 0;
  options.materials = {"glass", "steel"};
  const Packing first = read_mercury(frames, options);
  REQUIRE(first.bodies.size() == 2);
  CHECK(first.bodies[0].position == Vec3{{0.1, 0.2, 0.3}});
  CHECK(first.bodies[0].velocity == Vec3{{1, 2, 3}});
  CHECK(first.bodies[0].spin == Vec3{{4, 5, 6}});
  CHECK(first.bodies[0].radius == 0.01);
  CHECK(first.bodies[0].material == "glass");
  CHECK(first.bodies[1].material == "steel");
  options.timestep = 2;
  CHECK_THAT(refusal_of_mercury(frames, options),
             Contains("there is no frame 2 in 2 frames; give timestep = 0 to 1"));
}

TEST_CASE("a .data file of MercuryDPM in two dimensions has 8 columns, and 6 or 8 numbers in front",
          "[packing]") {
  for (const std::string head : {"1 0.5 0 0 1 2 \n", "1 0.5 0 0 0 1 2 0 \n"}) {
    const Packing packing = read_mercury(head + "0.1 0.2 1 2 0.01 9 7 0\n");
    CHECK(packing.dimension == 2);
    CHECK(packing.bodies[0].position == Vec3{{0.1, 0.2, 0}});
    CHECK(packing.bodies[0].velocity == Vec3{{1, 2, 0}});
    CHECK(packing.bodies[0].spin == Vec3{{0, 0, 7}});
    CHECK(packing.bodies[0].radius == 0.01);
    CHECK(packing.bounds->upper == Vec3{{1, 2, 0}});
  }
}

TEST_CASE("the species of MercuryDPM are materials, from 0, unless the scene has one", "[packing]") {
  ImportOptions options;
  options.materials = {"glass"};
  CHECK(read_mercury(frames, options).bodies[0].material == "glass");
  options.materials = {"glass", "steel"};
  CHECK(read_mercury(frames, options).bodies[0].material == "steel");
  CHECK_THAT(refusal_of_mercury("1 0 0 0 0 1 2 3\n0.1 0.2 0.3 1 2 3 0.01 9 9 9 4 5 6 2\n", options),
             StartsWith("m.data:2:36: species 2 has no material: counted from 0, the scene has only 2; "));
}

TEST_CASE("a .data file of MercuryDPM that is cut off or has other columns is refused", "[packing]") {
  CHECK_THAT(refusal_of_mercury("3" + frames.substr(1, 100)), Contains("m.data:"));
  CHECK_THAT(refusal_of_mercury("9 0 0 0 0 1 2 3\n0.1 0.2 0.3 1 2 3 0.01 9 9 9 4 5 6 0\n"),
             Contains("the frame is cut off after 1 of 9 bodies; complete the file"));
  CHECK_THAT(refusal_of_mercury("2 0 0 0 0 1 2 3\n0.1 0.2 0.3 1 2 3 0.01 9 9 9 4 5 6 0\n1 2 3\n"),
             Contains("m.data:3:1: 3 columns in a line of a body; "));
}
