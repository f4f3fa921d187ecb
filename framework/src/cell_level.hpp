#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <scree/domain.hpp>
#include <scree/particles.hpp>

namespace scree {

// One level of the cell hierarchy: bodies of similar size filed in a grid of cells at least as wide as the
// reach of any pair that is looked up in it, so that 3^D cells hold all partners.
class CellLevel {
 public:
  CellLevel(const Particles& particles, const Domain& domain, const Vec3& lower, const Vec3& upper,
            double reach, const std::vector<std::uint32_t>& bodies);

  // A body with what its neighbours are told by, in the order of the cells.
  struct Filed {
    Vec3 position;
    double radius;
    std::uint32_t body;
  };

  // Calls visit(filed) for every body filed in the cell around (x, y, z) or a neighbouring cell.
  template <class Visit>
  void near(const Vec3& x, const Visit& visit) const {
    std::array<std::array<int, 3>, 3> cells;
    std::array<int, 3> count;
    for (int k = 0; k < 3; ++k) count[k] = axis_cells(k, x[k], cells[k]);
    for (int p = 0; p < count[2]; ++p)
      for (int q = 0; q < count[1]; ++q)
        for (int r = 0; r < count[0]; ++r) {
          const std::size_t c =
              (std::size_t(cells[2][p]) * cells_[1] + cells[1][q]) * cells_[0] + cells[0][r];
          for (std::uint32_t s = first_[c]; s < first_[c + 1]; ++s) visit(filed_[s]);
        }
  }

 private:
  int cell_of(int axis, double x) const {
    return int(std::clamp((x - lower_[axis]) * inverse_width_[axis], 0.0, double(cells_[axis] - 1)));
  }
  // The cell of x and its neighbours along one axis, each once; returns how many.
  int axis_cells(int axis, double x, std::array<int, 3>& cells) const;

  Vec3 lower_;
  std::array<bool, 3> periodic_;
  std::array<int, 3> cells_;
  std::array<double, 3> inverse_width_;
  std::vector<std::uint32_t> first_;
  std::vector<Filed> filed_;
};

}  // namespace scree
