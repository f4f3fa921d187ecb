#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <scree/plugin/vec.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree {

// A surface as triangles, in 2D as segments, for pictures and files.
struct SurfaceOutline {
  std::vector<Vec3> points;          // (m)
  std::vector<std::uint32_t> cells;  // three points of each triangle, in 2D two of each segment
};

// The outline of a surface where it is now, and its facets, over which loads of contacts are spread: each
// triangle of a mesh; of other shapes two triangles of the outline, in 2D a segment.
struct FacetedSurface {
  SurfaceOutline outline;
  std::vector<std::uint32_t> facet;     // of each cell of the outline
  std::vector<double> area;             // (m²) of each facet, in 2D its length (m)
  std::vector<std::uint32_t> of_point;  // the facet that is nearest to each of the given points
};

// Where a surface is now. Of one that is infinite, the part around the box from lower to upper (m).
SurfaceOutline outline_of(const WallSurfaces& surfaces, std::size_t surface, int dimension, const Vec3& lower,
                          const Vec3& upper);
// The same with its facets, and those of points of the surface (m).
FacetedSurface facets_of(const WallSurfaces& surfaces, std::size_t surface, int dimension, const Vec3& lower,
                         const Vec3& upper, const std::vector<Vec3>& points);

}  // namespace scree
