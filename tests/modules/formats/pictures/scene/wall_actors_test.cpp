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

TEST_CASE("facets of surfaces are coloured by a map, from pale yellow to dark red", "[snapshot]") {
  Frame frame = pair({0.2, 0.2, 0.9}, {0.8, 0.8, 0.9}, 3);
  Surface floor;
  floor.name = "floor";
  floor.points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 0};
  floor.cells = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};  // below, right, above, left
  floor.normal_stress = {2000, 1e-9, -500, 0};
  frame.surfaces = {floor};
  const auto is_dark = [](const Rgb& c) {
    return c[0] > 140 && c[0] < 160 && c[1] < 10 && c[2] > 30 && c[2] < 50;
  };
  const auto is_pale = [](const Rgb& c) {
    return c[0] > 248 && c[1] > 215 && c[1] < 230 && c[2] > 150 && c[2] < 170;
  };
  RenderOptions options;
  options.view = "z";
  CHECK(find_blob(draw(frame, options), is_dark).pixels == 0);
  options.color_surfaces_by = "normal_stress";
  const Picture picture = draw(frame, options);
  const Blob dark = find_blob(picture, is_dark), pale = find_blob(picture, is_pale);
  // A quarter of a square of at least half the height each.
  CHECK(dark.pixels > picture.height * picture.height / 16 * 0.9);
  CHECK(pale.pixels > picture.height * picture.height / 16 * 0.9);
  CHECK(dark.y > pale.y);
  CHECK(pale.x > dark.x);
  options.color_surfaces_by = "sliding_work";
  CHECK_THAT(error_of([&] { draw(frame, options); }),
             Catch::Contains("have no sliding_work; run the scene with sliding_work = true in [snapshot]"));
}
