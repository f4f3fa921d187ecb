#include "sample_frame.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

TEST_CASE("a frame with columns of different length is refused and leaves no file", "[snapshot]") {
  const ScratchDirectory directory;
  Frame frame = sample_frame();
  frame.velocity.pop_back();
  CHECK_THAT(error_of([&] { backend().write_frame(frame, directory.path()); }),
             Contains("column velocity has 20 values instead of 21"));
  CHECK(std::filesystem::is_empty(directory.path()));
}
