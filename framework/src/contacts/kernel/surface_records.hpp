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
  // What is kept besides points, velocities and normals.
  struct Kept {
    bool slips;  // what friction dissipates
    bool paths;  // what laws read that follow bodies along surfaces
  };
  // first_row: of each group of pairs; rows: of all. width: of records.
  void plan(std::vector<std::size_t> first_row, std::size_t rows, std::size_t width, const Kept& kept) {
    first_row_ = std::move(first_row);
    width_ = width;
    records_.resize(width * rows, 0.0);
    normals_.resize(4 * rows, 0.0);
    levers_.resize(4 * rows, 0.0);
    mid_normals_.resize(4 * rows, 0.0);
    if (kept.slips) slips_.assign(rows, 0.0);
    // A stage may change whether there are any.
    normal_changes_.assign(kept.paths ? 6 * rows : 0, 0.0);
    orientations_.assign(kept.paths ? 4 * rows : 0, 0.0);
  }
  std::size_t first_row(std::size_t group) const { return first_row_[group]; }

  double* record(std::size_t row) { return records_.data() + width_ * row; }
  // Unit, from the surface to the body, at the end of the step and in its middle; and of the point, from the
  // origin of its frame (m).
  double* normal(std::size_t row) { return normals_.data() + 4 * row; }
  double* mid_normal(std::size_t row) { return mid_normals_.data() + 4 * row; }
  double* lever(std::size_t row) { return levers_.data() + 4 * row; }
  // As SCREE_NORMAL_CHANGE, and the quaternion of the frame; only if paths are kept.
  bool keep_paths() const { return !normal_changes_.empty(); }
  double* normal_change(std::size_t row) { return normal_changes_.data() + 6 * row; }
  double* orientation(std::size_t row) { return orientations_.data() + 4 * row; }
  const double* normal_change(std::size_t row) const { return normal_changes_.data() + 6 * row; }
  const double* orientation(std::size_t row) const { return orientations_.data() + 4 * row; }
  // (J) that friction has dissipated in the last evaluation, as laws say it; null if they are not kept.
  double* slips() { return slips_.empty() ? nullptr : slips_.data(); }
  const double* records() const { return records_.data(); }
  const double* normals() const { return normals_.data(); }          // (rows, 4)
  const double* mid_normals() const { return mid_normals_.data(); }  // (rows, 4)
  const double* levers() const { return levers_.data(); }            // (rows, 4)

 private:
  std::size_t width_ = 0;
  std::vector<std::size_t> first_row_;
  Column<double> records_, normals_, mid_normals_, levers_, slips_, normal_changes_, orientations_;
};

}  // namespace scree::kernel
