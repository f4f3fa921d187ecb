#pragma once

#include "machine/lanes.hpp"

#include <cstddef>
#include <vector>

#include <scree/column.hpp>
#include <scree/particles.hpp>
#include <scree/plugin/vec.hpp>

namespace scree::kernel {

// The nearest point of its surface for each pair of a body and a surface, in the record format of bodies: a
// body without radius at that point, with the velocity of the wall there; mid-step velocities are of the wall
// where the nearest point is in the middle of the step.
class SurfaceRecords {
 public:
  // first_row: of each group of pairs; rows: of all. width: of records.
  // slips: whether they are kept.
  void plan(std::vector<std::size_t> first_row, std::size_t rows, std::size_t width, bool slips) {
    first_row_ = std::move(first_row);
    width_ = width;
    records_.resize(width * rows, 0.0);
    normals_.resize(4 * rows, 0.0);
    levers_.resize(4 * rows, 0.0);
    mid_normals_.resize(4 * rows, 0.0);
    if (slips) slips_.assign(rows, 0.0);
  }
  std::size_t first_row(std::size_t group) const { return first_row_[group]; }

  double* record(std::size_t row) { return records_.data() + width_ * row; }
  // Unit, from the surface to the body, at the end of the step and in its middle; and of the point, from the
  // origin of its frame (m).
  double* normal(std::size_t row) { return normals_.data() + 4 * row; }
  double* mid_normal(std::size_t row) { return mid_normals_.data() + 4 * row; }
  double* lever(std::size_t row) { return levers_.data() + 4 * row; }
  // (J) that friction has dissipated in the last evaluation, as laws say it; null if they are not kept.
  double* slips() { return slips_.empty() ? nullptr : slips_.data(); }
  const double* records() const { return records_.data(); }
  const double* normals() const { return normals_.data(); }          // (rows, 4)
  const double* mid_normals() const { return mid_normals_.data(); }  // (rows, 4)
  const double* levers() const { return levers_.data(); }            // (rows, 4)

 private:
  std::size_t width_ = 0;
  std::vector<std::size_t> first_row_;
  Column<double> records_, normals_, mid_normals_, levers_, slips_;
};

}  // namespace scree::kernel
