#pragma once

#include <algorithm>
#include <cstddef>

namespace scree {

// Bodies [begin, end).
struct BodyRange {
  std::size_t begin, end;
};

// The bodies of a scene in tiles, which threads work on side by side. Tiles depend on the scene alone, never
// on the number of threads, so that sums over tiles in their order have the same bits for any number.
class BodyTiles {
 public:
  // Enough tiles for the threads of a large machine, large enough that few pairs cross from one to another.
  static constexpr std::size_t usual_size = 1024;

  explicit BodyTiles(std::size_t bodies) : bodies_(bodies) {}

  std::size_t count() const { return std::max<std::size_t>(1, bodies_ / usual_size); }
  BodyRange operator[](std::size_t tile) const {
    return {tile * usual_size, tile + 1 == count() ? bodies_ : (tile + 1) * usual_size};
  }

  // Calls visit(range) for a few bodies of a tile at a time, whose records stay in the first-level cache.
  template <class Visit>
  void each_few(std::size_t tile, const Visit& visit) const {
    constexpr std::size_t few = 128;
    const BodyRange all = (*this)[tile];
    for (std::size_t begin = all.begin; begin < all.end; begin += few)
      visit(BodyRange{begin, std::min(begin + few, all.end)});
  }

 private:
  std::size_t bodies_;
};

}  // namespace scree
