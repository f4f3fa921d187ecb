#include "meshes.hpp"
#include "numbers.hpp"
#include "scenes.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/plugin/rotation.hpp>
#include <scree/surface_outline.hpp>

// Facets of surfaces: cells of an outline, and which of them has a point.

using namespace scree;
using scree::test::infinite;
using std::numbers::pi;

namespace {

struct FacetedCase {
  const char* name;
  int dimension;
  scree_surface surface;
  double area;          // (m²), in 2D length (m)
  double share = 1e-3;  // by which flat cells may have less: (π/72)²/2 around, and twice that of a ball
};

const std::vector<FacetedCase> faceted_cases = {
    {"rectangle", 3, {SCREE_FLAT, SCREE_BOTH_SIDES, {0.7, 0.4}, nullptr, 0}, 4 * 0.7 * 0.4},
    {"tube", 3, {SCREE_REVOLVED, SCREE_INSIDE, {0.8, -0.6, 0.8, 0.7}, nullptr, 0}, 2 * pi * 0.8 * 1.3},
    {"cone",
     3,
     {SCREE_REVOLVED, SCREE_BOTH_SIDES, {0.9, -0.5, 0, 0.6}, nullptr, 0},
     pi * 0.9 * std::hypot(0.9, 1.1),
     2e-3},
    {"disc", 3, {SCREE_REVOLVED, SCREE_BOTH_SIDES, {0.9, 0, 0, 0}, nullptr, 0}, pi * 0.81, 2e-3},
    {"ball", 3, {SCREE_BALL, SCREE_BOTH_SIDES, {0.8, -infinite, infinite}, nullptr, 0}, 4 * pi * 0.64, 3e-3},
    {"zone", 3, {SCREE_BALL, SCREE_BOTH_SIDES, {0.8, -0.2, 0.5}, nullptr, 0}, 2 * pi * 0.8 * 0.7, 3e-3},
    {"segment", 2, {SCREE_FLAT, SCREE_BOTH_SIDES, {0.6}, nullptr, 0}, 1.2},
    {"circle", 2, {SCREE_BALL, SCREE_BOTH_SIDES, {0.7, -infinite, infinite}, nullptr, 0}, 2 * pi * 0.7},
    {"arc",
     2,
     {SCREE_BALL, SCREE_BOTH_SIDES, {0.7, -infinite, 0.2}, nullptr, 0},
     2 * 0.7 * std::acos(-0.2 / 0.7)},
};

// A surface that has been moved and turned.
WallSurfaces placed_as(const FacetedCase& c) {
  WallSurfaces all;
  all.shapes = {c.surface};
  all.meshes = {nullptr};
  const Rotation turn = Rotation::by(c.dimension == 2 ? Vec3{{0, 0, 0.7}} : Vec3{{0.3, -0.8, 0.5}});
  scree_frame frame = {{0.3, -0.2, c.dimension == 2 ? 0.0 : 0.1},
                       {turn.real, turn.axis[0], turn.axis[1], turn.axis[2]},
                       {},
                       {},
                       {},
                       {}};
  all.frames = {frame};
  return all;
}

double size_of_cell(const SurfaceOutline& outline, std::size_t corners, std::size_t cell) {
  const auto corner = [&](std::size_t k) { return outline.points[outline.cells[corners * cell + k]]; };
  const Vec3 side = corner(1) - corner(0);
  return corners == 2 ? norm(side) : 0.5 * norm(cross(side, corner(2) - corner(0)));
}

Vec3 middle_of_cell(const SurfaceOutline& outline, std::size_t corners, std::size_t cell) {
  Vec3 sum = {};
  for (std::size_t k = 0; k < corners; ++k) sum += outline.points[outline.cells[corners * cell + k]];
  return 1.0 / double(corners) * sum;
}

}  // namespace

TEST_CASE("the middle of each cell of an outline is in the facet of the cell", "[surfaces]") {
  for (const FacetedCase& c : faceted_cases) {
    INFO(c.name);
    const WallSurfaces surfaces = placed_as(c);
    const auto corners = std::size_t(c.dimension);
    const SurfaceOutline outline = outline_of(surfaces, 0, c.dimension, {}, {});
    std::vector<Vec3> middles;
    std::vector<double> sizes;
    for (std::size_t cell = 0; corners * cell < outline.cells.size(); ++cell) {
      middles.push_back(middle_of_cell(outline, corners, cell));
      sizes.push_back(size_of_cell(outline, corners, cell));
    }
    const FacetedSurface faceted = facets_of(surfaces, 0, c.dimension, {}, {}, middles);
    REQUIRE(faceted.outline.cells == outline.cells);
    REQUIRE(faceted.facet.size() == middles.size());
    std::vector<double> area(faceted.area.size(), 0.0);
    double all = 0;
    for (std::size_t cell = 0; cell < middles.size(); ++cell) {
      // At poles one of the two triangles of a facet has no area, and its middle lies on a side of it.
      if (sizes[cell] > 1e-12) CHECK(faceted.of_point[cell] == faceted.facet[cell]);
      area[faceted.facet[cell]] += sizes[cell];
      all += sizes[cell];
    }
    for (std::size_t facet = 0; facet < area.size(); ++facet) {
      CHECK(area[facet] > 0);
      CHECK(faceted.area[facet] == Approx(area[facet]));
    }
    CHECK(all <= c.area * (1 + 1e-12));
    CHECK(all >= c.area * (1 - c.share));
  }
}

TEST_CASE("facets of a mesh are its triangles", "[surfaces]") {
  const test::Mesh square = test::flat_mesh(1, 3, 2);
  Scene sc = test::scene(3, 1e-3, {test::body(1, 0.1, 1, {{0, 0, 9}})},
                         {{"normal_stiffness", {1}}, {"normal_damping", {0}}});
  test::add_boundary(sc, "mesh", {{"file", square.numbers()}, {"translation", {0.5, 0, 0}}});
  const Simulation s(sc);
  const SurfaceOutline outline = outline_of(s.surfaces(), 0, 3, {}, {});
  REQUIRE(outline.cells.size() == 3 * square.triangles.size());
  std::vector<Vec3> middles;
  for (std::size_t cell = 0; cell < square.triangles.size(); ++cell)
    middles.push_back(middle_of_cell(outline, 3, cell));
  const FacetedSurface faceted = facets_of(s.surfaces(), 0, 3, {}, {}, middles);
  CHECK(faceted.of_point == faceted.facet);
  REQUIRE(faceted.area.size() == square.triangles.size());
  for (const double area : faceted.area) CHECK(area == Approx(4.0 / 12));
}

TEST_CASE("an infinite surface has facets where the scene is", "[surfaces]") {
  const FacetedCase pipe = {
      "pipe", 3, {SCREE_REVOLVED, SCREE_INSIDE, {0.2, -infinite, 0.2, infinite}, nullptr, 0}, 0};
  WallSurfaces surfaces = placed_as(pipe);
  surfaces.frames[0].orientation[0] = 1;
  for (int k = 1; k < 4; ++k) surfaces.frames[0].orientation[k] = 0;
  const Vec3 lower = {{0, -1, 4}}, upper = {{1, 0, 6}}, point = {{0.5, -0.2, 5.9}};  // on the pipe
  const FacetedSurface faceted = facets_of(surfaces, 0, 3, lower, upper, {point});
  for (std::size_t cell = 0; cell < faceted.facet.size(); ++cell) {
    if (faceted.facet[cell] != faceted.of_point[0]) continue;
    // A cell is 17 mm wide and about as high.
    CHECK(norm(middle_of_cell(faceted.outline, 3, cell) - point) < 0.02);
  }
  const FacetedCase floor = {"floor", 3, {SCREE_FLAT, SCREE_BOTH_SIDES, {infinite, 0.5}, nullptr, 0}, 0};
  surfaces.shapes[0] = floor.surface;
  const Vec3 on_floor = {{0.9, -0.1, 0.1}};
  const FacetedSurface strip = facets_of(surfaces, 0, 3, lower, upper, {on_floor});
  for (std::size_t cell = 0; cell < strip.facet.size(); ++cell)
    if (strip.facet[cell] == strip.of_point[0])
      // Half of the diagonal of the box is 1.22 m: a cell is at most 0.11 m wide.
      CHECK(norm(middle_of_cell(strip.outline, 3, cell) - on_floor) < 0.11);
}
