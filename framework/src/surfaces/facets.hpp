#pragma once

#include "surfaces/triangle_mesh.hpp"

#include <cstddef>
#include <cstdint>

#include <scree/plugin/abi.h>
#include <scree/plugin/vec.hpp>

namespace scree {

// Cells of a surface that is no mesh: a grid of two parameters from 0 to 1, of which the first may go around
// the axis; in 2D one row, of a circle two, from its lowest to its highest point.
class FacetGrid {
 public:
  // The surface must be finite.
  FacetGrid(const scree_surface& surface, int dimension);

  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }
  // A corner of cells, in the frame of the surface (m); of a circle `row` is the side.
  Vec3 corner(std::uint32_t column, std::uint32_t row) const;
  // The cell that has the point of the surface nearest to x, row by row.
  std::size_t at(const Vec3& x) const;

 private:
  bool is_half_circle() const { return dimension_ == 2 && surface_.shape == SCREE_BALL; }
  std::uint32_t column_at(const Vec3& x) const;
  std::uint32_t row_at(const Vec3& x) const;

  scree_surface surface_;
  int dimension_;
  std::uint32_t columns_ = 1, rows_ = 1;
  double first_polar_ = 0, last_polar_ = 0;  // (rad) of a sphere, from its lowest point
};

// The facets of a surface, in its frame: the triangles of a mesh, or the cells of a grid.
class Facets {
 public:
  Facets(const scree_surface& surface, const TriangleMesh* mesh, int dimension);

  std::size_t size() const { return size_; }
  // The one that is nearest to a point (m).
  std::size_t at(const Vec3& x) const { return mesh_ ? mesh_->triangles().nearest(x).triangle : grid_.at(x); }
  const TriangleMesh* mesh() const { return mesh_; }
  const FacetGrid& grid() const { return grid_; }

 private:
  const TriangleMesh* mesh_;
  FacetGrid grid_;
  std::size_t size_;
};

// Whether a surface has no end in some direction, so that it has no facets.
bool is_infinite(const scree_surface& surface, int dimension);

}  // namespace scree
