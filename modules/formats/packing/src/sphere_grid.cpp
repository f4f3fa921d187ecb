#include "sphere_grid.hpp"

#include <algorithm>
#include <cmath>

namespace scree::packing {

namespace {

// A cell and its neighbours, the nearest first, which most often hold what overlaps.
std::vector<std::array<std::int64_t, 3>> offsets(int dimension) {
  std::vector<std::array<std::int64_t, 3>> all;
  const int depth = dimension == 3 ? 1 : 0;
  for (int z = -depth; z <= depth; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) all.push_back({x, y, z});
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2] < b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
  });
  return all;
}

}  // namespace

SphereGrid::SphereGrid(int dimension, const Domain& domain, double largest)
    : dimension_(dimension), domain_(domain), largest_(largest) {}

SphereGrid::Level& SphereGrid::level_of(double radius) {
  const auto index = std::size_t(std::max(0, std::ilogb(largest_ / radius)));
  while (levels_.size() <= index) {
    Level level = {{}, {}, std::vector<std::uint32_t>(1), {}, {}};
    const double diameter = 2.0 * std::ldexp(largest_, -int(levels_.size()));
    for (int k = 0; k < 3; ++k) {
      level.cell[k] = diameter;
      if (!domain_.periodic[std::size_t(k)]) continue;
      const double cells = std::max(1.0, std::floor(domain_.length(k) / diameter));
      level.period[std::size_t(k)] = std::int64_t(cells);
      level.cell[k] = domain_.length(k) / cells;
    }
    levels_.push_back(std::move(level));
  }
  return levels_[index];
}

SphereGrid::Cell SphereGrid::cell_of(const Level& level, const Vec3& position) const {
  Cell cell = {};
  for (int k = 0; k < dimension_; ++k)
    cell[std::size_t(k)] = std::int64_t(std::floor((position[k] - domain_.lower[k]) / level.cell[k]));
  return cell;
}

// Neighbours along x are neighbours in memory.
std::size_t SphereGrid::place(const Level& level, const Cell& cell) {
  std::array<std::uint64_t, 3> index;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t period = level.period[k], c = cell[k];
    index[k] = std::uint64_t(period == 0 ? c : c < 0 ? c + period : c >= period ? c - period : c);
  }
  std::uint64_t mixed = (index[1] * 0x9e3779b97f4a7c15 ^ index[2]) * 0xbf58476d1ce4e5b9;
  mixed ^= mixed >> 31;
  return (mixed + index[0]) & (level.head.size() - 1);
}

void SphereGrid::link(Level& level, std::size_t sphere) const {
  std::uint32_t& head = level.head[place(level, cell_of(level, level.spheres[sphere].position))];
  level.next[sphere] = head;
  head = std::uint32_t(sphere) + 1;
}

void SphereGrid::add(const Sphere& sphere, double as_radius) {
  Level& level = level_of(std::max(sphere.radius, as_radius));
  level.spheres.push_back(sphere);
  level.next.push_back(0);
  if (2 * level.spheres.size() <= level.head.size()) return link(level, level.spheres.size() - 1);
  level.head.assign(4 * level.head.size(), 0);
  for (std::size_t k = 0; k < level.spheres.size(); ++k) link(level, k);
}

bool SphereGrid::overlaps_in(const Level& level, const Cell& cell, const Sphere& sphere) {
  for (std::uint32_t n = level.head[place(level, cell)]; n > 0; n = level.next[n - 1]) {
    const Sphere& other = level.spheres[n - 1];
    ++distances_;
    Vec3 d = sphere.position - other.position;
    for (int k = 0; k < dimension_; ++k)
      if (domain_.periodic[std::size_t(k)]) d[k] -= domain_.length(k) * std::round(d[k] / domain_.length(k));
    const double reach = sphere.radius + other.radius;
    if (dot(d, d) < reach * reach) return true;
  }
  return false;
}

bool SphereGrid::overlaps(const Sphere& sphere) {
  static const std::vector<Cell> around[] = {offsets(2), offsets(3)};
  for (const Level& level : levels_) {
    if (level.spheres.empty()) continue;
    const Cell centre = cell_of(level, sphere.position);
    for (const Cell& o : around[dimension_ - 2])
      if (overlaps_in(level, {centre[0] + o[0], centre[1] + o[1], centre[2] + o[2]}, sphere)) return true;
  }
  return false;
}

}  // namespace scree::packing
