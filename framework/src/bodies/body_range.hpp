#pragma once

#include <algorithm>
#include <cstddef>

namespace scree {

// Bodies [begin, end).
struct BodyRange {
  std::size_t begin, end;
};

// Division of the bodies of a scene into tiles, the units of parallel work, and of tiles into parts, whose
// records stay in the first-level cache from one loop to the next. Both depend only on the scene, not on the
// number of threads, so that sums over them in order have the same bits for any number of threads.
class BodyTiles {
 public:
  // Small enough for the threads of a large machine, large enough that few pairs connect two tiles.
  static constexpr std::size_t usual_size = 1024;
  static constexpr std::size_t part_size = 128;

  explicit BodyTiles(std::size_t bodies) : bodies_(bodies) {}

  std::size_t size() const { return bodies_; }
  std::size_t count() const { return std::max<std::size_t>(1, bodies_ / usual_size); }
  // The tile of a body.
  std::size_t owner(std::size_t body) const { return std::min(body / usual_size, count() - 1); }
  BodyRange operator[](std::size_t tile) const {
    return {tile * usual_size, tile + 1 == count() ? bodies_ : (tile + 1) * usual_size};
  }

  // Parts are numbered consecutively over all tiles.
  std::size_t parts() const { return (bodies_ + part_size - 1) / part_size; }
  BodyRange part(std::size_t k) const { return {k * part_size, std::min((k + 1) * part_size, bodies_)}; }
  // Calls visit(part) for each part of a tile.
  template <class Visit>
  void each_part(std::size_t tile, const Visit& visit) const {
    const BodyRange all = (*this)[tile];
    for (std::size_t k = all.begin / part_size; k * part_size < all.end; ++k) visit(k);
  }

 private:
  std::size_t bodies_;
};

}  // namespace scree
