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

// Where a surface is now. Of one that is infinite, the part around the box from lower to upper (m).
SurfaceOutline outline_of(const WallSurfaces& surfaces, std::size_t surface, int dimension, const Vec3& lower,
                          const Vec3& upper);

}  // namespace scree
