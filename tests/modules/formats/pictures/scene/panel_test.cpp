#include "drawn_pair.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("the time of a picture is shown as exactly as the spacing of pictures asks", "[snapshot]") {
  RenderOptions options;
  options.width = 400, options.height = 300;
  const auto at = [&](double time, double spacing) {
    Frame frame = pair({0.3, 0.5, 0.5}, {0.7, 0.5, 0.5}, 2);
    frame.time = time;
    options.time_spacing = spacing;
    return draw(frame, options).rgb;
  };
  CHECK(at(0.0999984, 0.1) == at(0.1, 0));
  CHECK(at(0.0999984, 1e-5) != at(0.1, 0));
  CHECK(at(0.0999984, 0) != at(0.1, 0));
  CHECK(at(12.3456, 0.25) == at(12.346, 0));
  CHECK(at(0, 0.1) == at(0, 0));
}
