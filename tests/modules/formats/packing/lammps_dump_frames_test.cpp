#include "lammps_dump_frames.hpp"

#include "packing_support.hpp"

#include <optional>
#include <string>

#include <catch2/catch.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using scree::files::TextReader;

namespace {

const std::string four_frames =
    "ITEM: UNITS\nsi\nITEM: TIMESTEP\n0\nITEM: ATOMS x\n1\n"
    "ITEM: TIME\n0.5\nITEM: TIMESTEP\n100\nITEM: ATOMS x\n2\n"
    "ITEM: TIMESTEP\n100\nITEM: ATOMS x\n3\n"
    "ITEM: TIMESTEP\n200\nITEM: ATOMS x\n4\n";

// The number of the line in which the chosen frame begins.
std::size_t first_line(std::optional<std::int64_t> timestep) {
  TextReader reader(four_frames, "d");
  const std::vector<DumpFrame> frames = find_frames(reader);
  return choose_frame(frames, timestep, reader).start.line_number + 1;
}

}  // namespace

TEST_CASE("a frame of a dump begins with the first item behind the atoms before", "[packing]") {
  TextReader reader(four_frames, "d");
  CHECK(find_frames(reader).size() == 4);
  CHECK(first_line(0) == 1);
  CHECK(first_line(200) == 17);
}

TEST_CASE("of frames with one timestep the last counts, and without a timestep the last of all",
          "[packing]") {
  CHECK(first_line(100) == 13);
  CHECK(first_line(std::nullopt) == 17);
  CHECK_THAT(error_of([] { first_line(151); }),
             Contains("there is no timestep 151 in 4 frames; the nearest is 200"));
}
