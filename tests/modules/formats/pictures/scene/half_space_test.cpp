#include "scene/half_space.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("the ends of a cut are half-spaces, in the scene and as they are seen", "[pictures]") {
  const std::vector<HalfSpace> spaces = half_spaces({std::array{1.0, 2.0}, {}, std::array{-3.0, 5.0}});
  REQUIRE(spaces.size() == 4);
  CHECK(spaces[1].normal == Point{-1, 0, 0});
  CHECK(spaces[1].offset == -2);
  CHECK(spaces[2].normal == Point{0, 0, 1});
  CHECK(spaces[2].offset == -3);
  // A sphere that touches an end from outside has no part within.
  const double outside[] = {2.5, 0, 0}, crossing[] = {2.25, 7, 5.25};
  CHECK_FALSE(reaches_into(spaces, outside, 0.5));
  CHECK(reaches_into(spaces, crossing, 0.5));
  // From +x: right is y, up is z, towards the viewer is x; the centre of the camera is at (4, 0, 1).
  const std::vector<HalfSpace> in_view = seen(spaces, {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, {4, 0, 1}, 1, 1});
  CHECK(in_view[0].normal == Point{0, 0, 1});
  CHECK(in_view[0].offset == -3);
  CHECK(in_view[2].normal == Point{0, 1, 0});
  CHECK(in_view[2].offset == -4);
}

TEST_CASE("a polygon is clipped at a half-space", "[pictures]") {
  const std::vector<Point> square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  CHECK(clipped(square, {{1, 0, 0}, 1.5}) ==
        std::vector<Point>{{1.5, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1.5, 2, 0}});
  CHECK(clipped(square, {{1, 0, 0}, 3}).empty());
  CHECK(clipped(square, {{1, 0, 0}, -1}) == square);
}
