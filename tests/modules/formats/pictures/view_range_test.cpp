#include "sample_frame.hpp"

#include <cmath>
#include <limits>
#include <vector>

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
  last.walls = {{"floor", {0, -0.5, 0}, {0, 1, 0}}, {"slope", {0, -9, 0}, {0.6, 0.8, 0}}};
  view.add_box(first), view.add_colors(first);
  CHECK_FALSE(view.colors());  // of one value
  view.add_box(last), view.add_colors(last);
  CHECK(view.lower() == std::array{-1.0, -1.0, 0.0});
  CHECK(view.upper() == std::array{3.1, 1.0, 0.0});
  CHECK(*view.colors() == std::array{2.0, 5.0});
  // Walls count up to three extents of the bodies away, so that one that has gone leaves them in sight.
  Frame with_walls = disc(0, 2);
  with_walls.walls = {{"floor", {0, -0.6, 0}, {0, 1, 0}}, {"gate", {0, 9, 0}, {0, -1, 0}}};
  ViewRange near("speed");
  near.add_box(with_walls);
  CHECK(near.lower()[1] == -0.6);
  CHECK(near.upper()[1] == 0.1);
  Frame lost = disc(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  view.add_box(lost), view.add_colors(lost);
  CHECK(view.upper()[0] == 3.1);
  CHECK((*view.colors())[1] == 5.0);
}

TEST_CASE("bodies are coloured by the pressure of Love and Weber, and by their largest contact force",
          "[snapshot]") {
  constexpr double pi = 3.14159265358979323846;
  Frame frame;
  frame.id = {7, 9};
  frame.radius = {2.0, 1.0};
  frame.position = {0, 0, 0, 2.9, 0, 0};
  frame.contact_a = {7, 7};
  frame.contact_b = {9, -1};  // and a wall
  frame.contact_normal_force = {10, 4};
  frame.contact_overlap = {0.1, 0.2};
  frame.contact_force = {-10, 3, 0, 4, 0, 0};
  // Σ f_n (R − δ/2)/(3 V).
  const std::vector<double> pressure = color_values(frame, "pressure");
  REQUIRE(pressure.size() == 2);
  CHECK(pressure[0] == Approx((10 * 1.95 + 4 * 1.9) / (3 * 4.0 / 3 * pi * 8)));
  CHECK(pressure[1] == Approx(10 * 0.95 / (3 * 4.0 / 3 * pi)));
  CHECK(color_values(frame, "largest_force") ==
        std::vector<double>{std::hypot(10.0, 3.0), std::hypot(10.0, 3.0)});
  frame.dimension = 2;
  CHECK(color_values(frame, "pressure")[1] == Approx(10 * 0.95 / (2 * pi)));
  frame.contact_a.clear();  // a file of an earlier version
  CHECK(color_values(frame, "pressure").empty());
}
