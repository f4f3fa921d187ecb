#include "field_scenes.hpp"

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/fields/grid_request.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::fields;

namespace {

FieldInput two_bodies() {
  FieldInput input;
  input.domain = {{true, false, false}, {{-1, 0, 0}}, {{2, 0, 0}}};
  input.bodies = {{.id = 1, .mass = 1, .radius = 0.5, .position = {{0, 0, 0}}},
                  {.id = 2, .mass = 1, .radius = 1.5, .position = {{0, 4, 1}}}};
  return input;
}

std::string refused_grid(const GridRequest& request) {
  try {
    grid_for(request, two_bodies());
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a grid fills the period or the bodies with whole cells", "[fields]") {
  CHECK(kernel_for({}, two_bodies()).width() == 4);
  GridRequest request;
  request.spacing = 0.9;
  const FieldGrid grid = grid_for(request, two_bodies());
  CHECK(grid.period == Vec3{{3, 0, 0}});
  CHECK(grid.count == std::array<std::size_t, 3>{3, 7, 3});  // of 3, 6 and 3 m
  CHECK(grid.spacing[0] == 1);
  CHECK(grid.first[0] == -0.5);
  CHECK(grid.spacing[1] == Approx(6.0 / 7));
  CHECK(grid.first[1] == Approx(-0.5 + 3.0 / 7));
  CHECK(grid.first[2] == Approx(0));
  CHECK(grid.point(22)[0] == Approx(0.5));  // 22 = 1 + 3 (0 + 7)
  CHECK(grid.point(22)[2] == Approx(grid.spacing[2]));
}

TEST_CASE("a grid has one layer on a plane and the corners that are given", "[fields]") {
  GridRequest request;
  request.plane_axis = 1;
  request.plane = 0.25;
  request.lower = Vec3{{0, 7, -1}};
  request.upper = Vec3{{1, 7, 1}};
  request.spacing = 0.5;
  const FieldGrid grid = grid_for(request, two_bodies());
  CHECK(grid.count == std::array<std::size_t, 3>{2, 1, 4});
  CHECK(grid.first == Vec3{{0.25, 0.25, -0.75}});
}

TEST_CASE("grids without a volume, beyond the memory or of too many points for a body are refused",
          "[fields]") {
  GridRequest request;
  request.upper = Vec3{{-1, 1, 1}};
  CHECK(refused_grid(request) ==
        "upper: is not above the lower end along x (-1 m); give a box with a volume");
  request = {};
  request.spacing = 1e-5;
  CHECK_THAT(refused_grid(request),
             Catch::StartsWith("spacing: gives ") && Catch::Contains("GB of memory; give a larger one"));
  request = {};
  request.width = 1e5;
  request.spacing = 1;
  CHECK_THAT(refused_grid(request),
             Catch::StartsWith("width: is so large that each body adds to 8e+15 points; give"));
  // A kernel of many periods along x, although there is one layer of points.
  request.width = 1e8;
  request.spacing = 1e8;
  CHECK_THAT(refused_grid(request), Catch::StartsWith("width: is so large"));
  request = {};
  request.width = 1;
  request.plane_axis = 0;
  request.plane = -302;
  CHECK(
      refused_grid(request) ==
      "plane: the grid is more than 100 periods away along x; give a plane, lower and upper near the scene");
  request.plane = 1e300;
  CHECK_THAT(refused_grid(request), Catch::Contains("periods away"));
  request.plane = -300;
  CHECK(refused_grid(request).empty());
}
