#include "drawn_pair.hpp"

#include <functional>
#include <limits>

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

TEST_CASE("frames without particles or with equal ones are drawn", "[snapshot]") {
  const auto is_ink = [](const Rgb& c) { return c[0] < 250; };
  CHECK(find_blob(draw(Frame{}, {}), is_ink).pixels == 0);
  for (const char* field : {"radius", "speed", "id"}) {
    RenderOptions options;
    options.color_by = field;
    CHECK(find_blob(draw(pair({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}, 3), options), is_ink).pixels > 1000);
  }
}

TEST_CASE("pictures that cannot be drawn are refused", "[snapshot]") {
  const ScratchDirectory directory;
  const auto refusal = [&](const Frame& frame, const RenderOptions& options) {
    return error_of([&] { backend().render(frame, options, directory / "picture.png"); });
  };
  const Frame frame = pair({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}, 3);
  RenderOptions options;
  options.color_by = "sped";
  CHECK_THAT(refusal(frame, options), Contains("\"sped\"") && Contains("speed"));
  options.color_by = "spin";
  CHECK_THAT(refusal(frame, options), Contains("has no spin"));
  CHECK_THAT(refusal(frame, by_speed("top")), Contains("\"top\"") && Contains("iso"));
  options = {};
  options.color_range = {2, 1};
  CHECK_THAT(refusal(frame, options), Contains("color_range"));
  options = {};
  options.width = 20;
  CHECK_THAT(refusal(frame, options), Contains("20 x 900"));
  Frame broken = frame;
  broken.position[4] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(refusal(broken, {}), Contains("position of item 1"));
  CHECK(std::filesystem::is_empty(directory.path()));
}
