#pragma once

#include "scree/packing/packing.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scree::packing {

// Two overlapping bodies, by index in the packing; first == second: a body and its own periodic image.
struct ClosePair {
  std::size_t first;
  std::size_t second;
  double distance;  // (m) between the centres of the nearest periodic images
};

// Finds overlapping pairs. Bodies are sorted into size classes with radii within a factor of 2, each with its
// own grid and cell size, so that small bodies among large ones do not overfill the cells.
class ClosePairs {
 public:
  // The packing must outlive this and pass check().
  explicit ClosePairs(const Packing& packing);

  // Calls visit(pair) at least once per pair; twice if the cells of the pair share a hash bucket.
  // Stops when visit returns false.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t i = 0; i < packing_.bodies.size(); ++i) {
      if (!visit_own_image(i, visit)) return;
      for (const Grid& grid : grids_) {
        if (!visit_grid(i, grid, visit)) return;
      }
    }
  }

 private:
  struct Grid {
    int size_class = 0;
    double largest_radius = 0.0;          // (m)
    std::array<double, 3> cell{};         // (m) edge, at least twice the largest radius
    std::array<std::int64_t, 3> cells{};  // number along a periodic axis; 0: unlimited
    std::vector<std::int64_t> first;      // first body of each bucket; -1: none
    std::size_t mask = 0;                 // number of buckets - 1
  };
  // Indices of the cells next to a body along one axis.
  struct Span {
    std::array<std::int64_t, 3> index;
    int count;
  };

  void build_grid(int size_class);
  int size_class(double radius) const;
  double periodic_length(int axis) const;
  std::int64_t cell_index(const Grid& grid, double x, int axis) const;
  Span neighbours(const Grid& grid, double x, int axis) const;
  static std::size_t bucket(const Grid& grid, std::int64_t x, std::int64_t y, std::int64_t z);
  double distance(std::size_t i, std::size_t j) const;

  template <class Visit>
  bool visit_own_image(std::size_t i, Visit& visit) const {
    for (int k = 0; k < packing_.dimension; ++k) {
      const double length = periodic_length(k);
      if (length > 0.0 && length < 2.0 * packing_.bodies[i].radius && !visit(ClosePair{i, i, length})) {
        return false;
      }
    }
    return true;
  }

  template <class Visit>
  bool visit_grid(std::size_t i, const Grid& grid, Visit& visit) const {
    const Vec3& x = packing_.bodies[i].position;
    const int own_class = size_class(packing_.bodies[i].radius);
    if (own_class > grid.size_class) return true;
    const Span along_x = neighbours(grid, x[0], 0);
    const Span along_y = neighbours(grid, x[1], 1);
    const Span along_z = packing_.dimension == 3 ? neighbours(grid, x[2], 2) : Span{{0, 0, 0}, 1};
    for (int c = 0; c < along_z.count; ++c) {
      for (int b = 0; b < along_y.count; ++b) {
        for (int a = 0; a < along_x.count; ++a) {
          const std::size_t index = bucket(grid, along_x.index[a], along_y.index[b], along_z.index[c]);
          if (!visit_bucket(i, own_class == grid.size_class, grid.first[index], visit)) return false;
        }
      }
    }
    return true;
  }

  // A pair of the same class is found from both bodies; only the one with i < j is reported.
  template <class Visit>
  bool visit_bucket(std::size_t i, bool same_class, std::int64_t entry, Visit& visit) const {
    for (; entry >= 0; entry = next_[std::size_t(entry)]) {
      const auto j = std::size_t(entry);
      if (j == i || (same_class && j < i)) continue;
      const double separation = distance(i, j);
      if (separation < packing_.bodies[i].radius + packing_.bodies[j].radius &&
          !visit(ClosePair{i, j, separation}))
        return false;
    }
    return true;
  }

  const Packing& packing_;
  double smallest_radius_;  // (m)
  std::vector<Grid> grids_;
  std::vector<std::int64_t> next_;  // next body in the same bucket; -1: none
};

}  // namespace scree::packing
