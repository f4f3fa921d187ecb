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
    const Spans along[3] = {spans(0, x[0]), spans(1, x[1]), spans(2, x[2])};
    const auto each = [](const Spans& s, const auto& use) {
      for (int k = 0; k < s.count; ++k)
        for (int cell = s.first[k]; cell <= s.last[k]; ++cell) use(cell);
    };
    each(along[2], [&](int plane) {
      each(along[1], [&](int line) {
        const std::size_t row = (std::size_t(plane) * cells_[1] + line) * cells_[0];
        // Cells of a row lie one after the other.
        for (int k = 0; k < along[0].count; ++k)
          for (std::uint32_t s = first_[row + along[0].first[k]]; s < first_[row + along[0].last[k] + 1]; ++s)
            visit(filed_[s]);
      });
    });
  }

 private:
  int cell_of(int axis, double x) const {
    return int(std::clamp((x - lower_[axis]) * inverse_width_[axis], 0.0, double(cells_[axis] - 1)));
  }
  // The cell of x and its neighbours along one axis, each once: one or two runs of cells [first, last].
  struct Spans {
    int count;
    std::array<int, 2> first, last;
  };
  Spans spans(int axis, double x) const;

  Vec3 lower_;
  std::array<bool, 3> periodic_;
  std::array<int, 3> cells_;
  std::array<double, 3> inverse_width_;
  std::vector<std::uint32_t> first_;
  std::vector<Filed> filed_;
};

}  // namespace scree
