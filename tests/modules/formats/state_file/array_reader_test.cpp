#include "array_reader.hpp"

#include "temporary_folder.hpp"

#include <fcntl.h>
#include <string>
#include <unistd.h>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

using namespace scree;
using namespace scree::state_file;
using Catch::Matchers::Contains;

namespace {

// 32 bytes: two numbers of 64 bits, and texts in 16 bytes.
const std::string content = std::string("\1\0\0\0\0\0\0\0", 8) + std::string("\0\1\0\0\0\0\0\0", 8) +
                            std::string("glass\0\0\0stone\0\0\0", 16);
constexpr std::uint64_t unsigned_kind = 3, texts_kind = 7;  // places in StateArray::values

StateArray read(std::vector<PlacedArray> places, double memory = 1e9) {
  const test::TemporaryFolder folder;
  const int descriptor = open(folder.write("a", content).c_str(), O_RDONLY);
  ArrayReader reader(descriptor, content.size(), memory);
  StateArray last;
  try {
    for (const PlacedArray& place : places) last = reader.read(place);
  } catch (...) {
    close(descriptor);
    throw;
  }
  close(descriptor);
  return last;
}

std::string refusal_of_places(const std::vector<PlacedArray>& places, double memory = 1e9) {
  try {
    read(places, memory);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

PlacedArray numbers() {
  return {
      .path = "a", .kind = unsigned_kind, .unit = "1", .shape = {2}, .offset = 0, .width = 8, .lengths = {}};
}

PlacedArray words() {
  return {.path = "b", .kind = texts_kind, .unit = "", .shape = {2}, .offset = 16, .width = 8, .lengths = {}};
}

}  // namespace

TEST_CASE("An array has the numbers at its place, the lowest byte first", "[array_reader]") {
  CHECK(read({numbers()}) == StateArray{std::vector<std::uint64_t>{1, 256}, {2}, "1"});
  PlacedArray one = numbers();
  one.offset = 8, one.shape = {};
  CHECK(read({one}) == StateArray{std::vector<std::uint64_t>{256}, {}, "1"});
}

TEST_CASE("Texts end at the zeros that fill them, or have their lengths", "[array_reader]") {
  PlacedArray place = words();
  CHECK(read({place}) == StateArray{std::vector<std::string>{"glass", "stone"}, {2}, ""});
  place.lengths = {7, 0};
  CHECK(read({place}) == StateArray{std::vector<std::string>{std::string("glass\0\0", 7), ""}, {2}, ""});
  place.lengths = {9, 0};
  CHECK(refusal_of_places({place}) == "'b' has texts longer than their room");
  place.lengths = {1};
  CHECK(refusal_of_places({place}) == "'b' has no lengths for its texts");
}

TEST_CASE("A place that cannot be in the file takes no memory", "[array_reader]") {
  const auto changed = [](auto change) {
    PlacedArray place = numbers();
    change(place);
    return refusal_of_places({place});
  };
  CHECK(changed([](PlacedArray& p) {
          p.shape = {1ull << 40, 1ull << 40};
        }) == "'a' claims more bytes than are in the file");
  CHECK(changed([](PlacedArray& p) { p.offset = 17; }) == "'a' lies beyond the end of the file");
  CHECK(changed([](PlacedArray& p) { p.offset = ~0ull; }) == "'a' lies beyond the end of the file");
  CHECK(changed([](PlacedArray& p) { p.width = 4; }) == "'a' has a type that no state has");
  CHECK(changed([](PlacedArray& p) { p.kind = 8; }) == "'a' has a type that no state has");
  CHECK_THAT(changed([](PlacedArray& p) { p.path = "A"; }), Contains("whose name is not that of an array"));
  // Each of the arrays is within the file, but not all of them together.
  CHECK(refusal_of_places({numbers(), numbers()}).empty());
  CHECK(refusal_of_places({numbers(), numbers(), numbers()}) == "'a' claims more bytes than are in the file");
  CHECK(refusal_of_places({numbers(), words()}, 31) ==
        "'b' does not fit into memory with the arrays before it");
}
