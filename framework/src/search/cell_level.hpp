#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <scree/domain.hpp>
#include <scree/pair_search.hpp>

namespace scree {

// One level of the cell hierarchy: bodies of similar size binned into a grid of cells at least as wide as the
// reach of any pair that is searched in it, so that 3^D cells contain all partners. If bodies are spread so
// far that there would be many more cells than bodies, the grid is wrapped around: positions a fixed number
// of cells apart share a cell.
class CellLevel {
 public:
  // Replaces the contents by the bodies with the indices `members`. lower, upper, reach in m.
  void bin(std::span<const Sphere> bodies, int dimension, const Domain& domain, const Vec3& lower,
           const Vec3& upper, double reach, const std::vector<std::uint32_t>& members);

  struct BinnedBody : Sphere {
    std::uint32_t body;
  };

  // The bodies in the order of the cells.
  const std::vector<BinnedBody>& binned() const { return binned_; }

  // A cell and its neighbours along one axis, each once: one or two runs of adjacent cells [first, last].
  struct Spans {
    int count;
    std::array<int, 2> first, last;
  };
  // The cell that contains a position, and its neighbours.
  struct Surroundings {
    Spans along[3];
    bool across;  // some of them are across a periodic face
  };
  Surroundings around(const Vec3& x) const {
    Surroundings s = {{}, false};
    for (int k = 0; k < 3; ++k) {
      const int cell = cell_of(k, x[k]);
      s.along[k] = spans(k, cell);
      s.across |= periodic_[k] && (cell == 0 || cell + 1 == cells_[k]);
    }
    return s;
  }
  // Calls use(begin, end) for all runs of bodies in these cells.
  template <class Use>
  void each_run(const Surroundings& s, const Use& use) const {
    const auto each = [](const Spans& spans, const auto& visit) {
      for (int k = 0; k < spans.count; ++k)
        for (int cell = spans.first[k]; cell <= spans.last[k]; ++cell) visit(cell);
    };
    each(s.along[2], [&](int plane) {
      each(s.along[1], [&](int line) {
        const std::size_t row = (std::size_t(plane) * cells_[1] + line) * cells_[0];
        // The cells of a row are adjacent in memory.
        for (int k = 0; k < s.along[0].count; ++k)
          use(first_[row + s.along[0].first[k]], first_[row + s.along[0].last[k] + 1]);
      });
    });
  }

 private:
  int cell_of(int axis, double x) const {
    double cell = (x - lower_[axis]) * inverse_width_[axis];
    if (wrapped_[axis]) cell -= cells_[axis] * std::floor(cell / cells_[axis]);
    return int(std::clamp(cell, 0.0, double(cells_[axis] - 1)));
  }
  void choose_cells(const Vec3& lower, const Vec3& upper, double reach, int dimension, std::size_t bodies);
  Spans spans(int axis, int middle) const;

  Vec3 lower_;
  std::array<bool, 3> periodic_, wrapped_;
  std::array<int, 3> cells_;
  std::array<double, 3> inverse_width_;
  std::vector<std::uint32_t> first_;  // first binned body of each cell
  std::vector<std::uint32_t> cell_;   // cell of each member
  std::vector<BinnedBody> binned_;
};

}  // namespace scree
