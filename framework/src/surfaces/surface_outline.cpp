#include "surfaces/facets.hpp"
#include "surfaces/placed_surface.hpp"

#include <algorithm>
#include <cmath>

#include <scree/surface_outline.hpp>

namespace scree {

namespace {

// What is in view of an infinite line: its part within a radius (m) of the place nearest to the view.
struct View {
  Vec3 centre;  // in the frame of the surface
  double radius;
};

// A surface as it is, or the part of it that is in view, moved along its frame by `by`.
struct Part {
  scree_surface surface;
  Vec3 by = {};
};

Part part_in(const View& view, scree_surface s) {
  Part part = {s};
  if (s.shape == SCREE_REVOLVED && std::isinf(s.size[1])) {
    part.surface.size[1] = view.centre[2] - view.radius;
    part.surface.size[3] = view.centre[2] + view.radius;
  }
  for (int k = 0; s.shape == SCREE_FLAT && k < 2; ++k)
    if (std::isinf(s.size[k])) part.surface.size[k] = view.radius, part.by[k] = view.centre[k];
  return part;
}

void add_cells(const FacetGrid& grid, int dimension, bool rows_are_lines, SurfaceOutline& outline) {
  const std::uint32_t points = grid.columns() + 1;
  const std::uint32_t lines = rows_are_lines ? grid.rows() : grid.rows() + 1;
  for (std::uint32_t j = 0; j < lines; ++j)
    for (std::uint32_t i = 0; i < points; ++i) outline.points.push_back(grid.corner(i, j));
  for (std::uint32_t j = 0; j < grid.rows(); ++j)
    for (std::uint32_t i = 0; i < grid.columns(); ++i) {
      const std::uint32_t a = j * points + i, b = a + points;
      if (dimension == 2)
        outline.cells.insert(outline.cells.end(), {a, a + 1});
      else
        outline.cells.insert(outline.cells.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
}

SurfaceOutline of_mesh(const TriangleMesh& mesh) {
  SurfaceOutline outline;
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t)
    for (const Vec3& corner : mesh.triangles()[t].corner) {
      outline.cells.push_back(std::uint32_t(outline.points.size()));
      outline.points.push_back(corner);
    }
  return outline;
}

// A surface in view.
struct InView {
  PlacedSurface placed;
  Part part;
  Facets facets;

  InView(const WallSurfaces& surfaces, std::size_t surface, int dimension, const Vec3& lower,
         const Vec3& upper)
      : placed(surfaces, surface, dimension, 0),
        part(part_in({placed.in_frame(0.5 * (lower + upper)), 0.5 * norm(upper - lower)},
                     surfaces.shapes[surface])),
        facets(part.surface, placed.mesh(), dimension) {}

  SurfaceOutline outline(int dimension) const {
    SurfaceOutline outline;
    if (placed.mesh())
      outline = of_mesh(*placed.mesh());
    else
      add_cells(facets.grid(), dimension, dimension == 2, outline);
    for (Vec3& point : outline.points) point = placed.in_scene({point + part.by, {}, 0, {}}).point;
    return outline;
  }
};

double area_of_cell(const SurfaceOutline& outline, std::size_t corners, std::size_t cell) {
  const auto corner = [&](std::size_t k) { return outline.points[outline.cells[corners * cell + k]]; };
  const Vec3 side = corner(1) - corner(0);
  return corners == 2 ? norm(side) : 0.5 * norm(cross(side, corner(2) - corner(0)));
}

}  // namespace

SurfaceOutline outline_of(const WallSurfaces& surfaces, std::size_t surface, int dimension, const Vec3& lower,
                          const Vec3& upper) {
  return InView(surfaces, surface, dimension, lower, upper).outline(dimension);
}

FacetedSurface facets_of(const WallSurfaces& surfaces, std::size_t surface, int dimension, const Vec3& lower,
                         const Vec3& upper, const std::vector<Vec3>& points) {
  const InView view(surfaces, surface, dimension, lower, upper);
  FacetedSurface faceted = {view.outline(dimension), {}, std::vector<double>(view.facets.size(), 0.0), {}};
  const auto corners = std::size_t(dimension), cells = faceted.outline.cells.size() / corners;
  const std::size_t cells_of_facet = cells / view.facets.size();
  for (std::size_t cell = 0; cell < cells; ++cell) {
    faceted.facet.push_back(std::uint32_t(cell / cells_of_facet));
    faceted.area[faceted.facet.back()] += area_of_cell(faceted.outline, corners, cell);
  }
  for (const Vec3& point : points)
    faceted.of_point.push_back(std::uint32_t(view.facets.at(view.placed.in_frame(point) - view.part.by)));
  return faceted;
}

}  // namespace scree
