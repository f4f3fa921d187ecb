#include "placed_array.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::state_file;

namespace {

std::vector<PlacedArray> some_arrays() {
  return {{.path = "bodies/position",
           .kind = 0,
           .unit = "m",
           .shape = {2, 3},
           .offset = 512,
           .width = 8,
           .lengths = {},
           .dataset = "particles/bodies/position/value",
           .as_frame = 1},
          {},
          {.path = "scene/materials",
           .kind = 7,
           .unit = "",
           .shape = {2},
           .offset = ~0ull,
           .width = 5,
           .lengths = {5, 0}}};
}

}  // namespace

TEST_CASE("Places of arrays arrive as they were sent", "[placed_array]") {
  CHECK(unpacked(packed(some_arrays())) == some_arrays());
  CHECK(unpacked("").empty());
}

TEST_CASE("Bytes that end within an array, or claim more than there are, are refused", "[placed_array]") {
  const std::string whole = packed(some_arrays());
  const std::vector<std::size_t> ends = {0, packed({some_arrays()[0]}).size(),
                                         whole.size() - packed({some_arrays()[2]}).size()};
  std::size_t accepted = 0;
  for (std::size_t length = 0; length < whole.size(); ++length) try {
      accepted += unpacked(whole.substr(0, length)).size() < some_arrays().size();
      CHECK(std::find(ends.begin(), ends.end(), length) != ends.end());
    } catch (const std::length_error& error) {
      CHECK(std::string(error.what()) == "a list of arrays ends early");
    }
  CHECK(accepted == ends.size());
  // A path of 2^64 - 1 bytes.
  CHECK_THROWS_AS(unpacked(std::string(8, '\xFF') + whole), std::length_error);
}
