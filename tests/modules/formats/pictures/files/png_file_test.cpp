#include "sample_frame.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

TEST_CASE("a file that is not a picture is refused", "[pictures]") {
  const ScratchDirectory directory;
  std::ofstream(directory / "text.png") << "not a picture";
  CHECK_THAT(error_of([&] { backend().read_png(directory / "text.png"); }), Contains("text.png"));
  CHECK_THAT(error_of([&] { backend().read_png(directory / "absent.png"); }), Contains("absent.png"));
}
