#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <scree/domain.hpp>
#include <scree/pair_search.hpp>

namespace scree::packing {

// Spheres that are added one after the other, the largest first, in cells of their size: a question about
// another one that is not larger looks at 3^dimension cells for each power of two between the sizes so far.
class SphereGrid {
 public:
  // No sphere may be larger than `largest` (m). Distances along periodic axes of the domain are the shortest
  // ones.
  SphereGrid(int dimension, const Domain& domain, double largest);

  // Adds a sphere; one that is smaller than later ones is to be added with `as_radius`, the largest of those.
  void add(const Sphere& sphere, double as_radius);
  // Whether a sphere, not larger than those added so far, overlaps one of them.
  bool overlaps(const Sphere& sphere);
  // How many distances have been computed.
  std::size_t distances() const { return distances_; }

 private:
  using Cell = std::array<std::int64_t, 3>;
  // Spheres with the same power of two of largest/radius. Cells are the places of a table, which they may
  // share.
  struct Level {
    Vec3 cell;                        // (m) edges
    Cell period;                      // cells along periodic axes; 0 along others
    std::vector<std::uint32_t> head;  // first sphere of each place, by index + 1; a power of two
    std::vector<std::uint32_t> next;  // of each sphere
    std::vector<Sphere> spheres;
  };

  Level& level_of(double radius);
  Cell cell_of(const Level& level, const Vec3& position) const;
  bool overlaps_in(const Level& level, const Cell& cell, const Sphere& sphere);
  static std::size_t place(const Level& level, const Cell& cell);
  void link(Level& level, std::size_t sphere) const;

  int dimension_;
  Domain domain_;
  double largest_;
  std::vector<Level> levels_;
  std::size_t distances_ = 0;
};

}  // namespace scree::packing
