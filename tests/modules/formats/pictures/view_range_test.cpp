#include "sample_frame.hpp"

#include <limits>

#include <catch2/catch.hpp>

#include <scree/pictures/view_range.hpp>

using namespace scree::pictures;

namespace {

Frame disc(double x, double speed) {
  Frame frame;
  frame.dimension = 2;
  frame.id = {1};
  frame.radius = {0.1};
  frame.position = {x, 0, 0};
  frame.velocity = {0, speed, 0};
  return frame;
}

}  // namespace

TEST_CASE("the view of several frames holds their boxes, bodies and walls and all their values",
          "[snapshot]") {
  ViewRange view("speed");
  CHECK_FALSE(view.colors());
  Frame first = disc(0, 2), last = disc(3, 5);
  first.lower = {-1, -1, 0}, first.upper = {1, 1, 0};
  last.walls = {{"floor", {0, -2, 0}, {0, 1, 0}}, {"slope", {0, -9, 0}, {0.6, 0.8, 0}}};
  view.add_box(first), view.add_colors(first);
  CHECK_FALSE(view.colors());  // of one value
  view.add_box(last), view.add_colors(last);
  CHECK(view.lower() == std::array{-1.0, -2.0, 0.0});
  CHECK(view.upper() == std::array{3.1, 1.0, 0.0});
  CHECK(*view.colors() == std::array{2.0, 5.0});
  Frame lost = disc(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  view.add_box(lost), view.add_colors(lost);
  CHECK(view.upper()[0] == 3.1);
  CHECK((*view.colors())[1] == 5.0);
}
