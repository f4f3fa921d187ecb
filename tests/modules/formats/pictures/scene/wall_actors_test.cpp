#include "drawn_pair.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("walls are visible without hiding the spheres", "[snapshot]") {
  Frame frame = pair({0.2, 0.3, 0.4}, {0.7, 0.8, 0.6}, 3);
  for (int k = 0; k < 3; ++k)
    for (double side : {0.0, 1.0}) {
      Wall wall{"wall", {side, side, side}, {}};
      wall.normal[k] = 1 - 2 * side;
      frame.walls.push_back(wall);
    }
  const auto is_wall = [](const Rgb& c) { return c[0] < 245 && c[0] > 210 && c[2] > c[0]; };
  RenderOptions options = by_speed("iso");
  const Picture with_walls = draw(frame, options);
  options.show_walls = false;
  const Picture without_walls = draw(frame, options);
  CHECK(find_blob(with_walls, is_wall).pixels > 50000);
  CHECK(find_blob(without_walls, is_wall).pixels < 500);
  CHECK(find_blob(with_walls, is_yellow).pixels > 0.9 * find_blob(without_walls, is_yellow).pixels);
}
