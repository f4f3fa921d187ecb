#include "close_pairs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <utility>

namespace scree::packing {

ClosePairs::ClosePairs(const Packing& packing) : packing_(packing), next_(packing.bodies.size(), -1) {
  const auto smaller = [](const Body& a, const Body& b) { return a.radius < b.radius; };
  smallest_radius_ = std::min_element(packing.bodies.begin(), packing.bodies.end(), smaller)->radius;
  std::set<int> classes;
  for (const Body& body : packing.bodies) classes.insert(size_class(body.radius));
  for (const int size_class : classes) build_grid(size_class);
}

int ClosePairs::size_class(double radius) const { return std::ilogb(radius) - std::ilogb(smallest_radius_); }

double ClosePairs::periodic_length(int axis) const {
  if (!packing_.periodic[axis]) return 0.0;
  return packing_.bounds->upper[axis] - packing_.bounds->lower[axis];
}

void ClosePairs::build_grid(int size_class) {
  Grid grid;
  grid.size_class = size_class;
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < packing_.bodies.size(); ++i) {
    const double radius = packing_.bodies[i].radius;
    if (this->size_class(radius) != size_class) continue;
    members.push_back(i);
    grid.largest_radius = std::max(grid.largest_radius, radius);
  }
  constexpr double max_cells = 1e9;
  for (int k = 0; k < 3; ++k) {
    const double length = periodic_length(k);
    grid.cell[k] = 2.0 * grid.largest_radius;
    if (length == 0.0) continue;
    grid.cells[k] = std::int64_t(std::clamp(std::floor(length / grid.cell[k]), 1.0, max_cells));
    grid.cell[k] = length / double(grid.cells[k]);
  }
  grid.mask = std::bit_ceil(2 * members.size()) - 1;
  grid.first.assign(grid.mask + 1, -1);
  for (const std::size_t i : members) {
    const Vec3& x = packing_.bodies[i].position;
    const std::int64_t z = packing_.dimension == 3 ? cell_index(grid, x[2], 2) : 0;
    std::int64_t& first = grid.first[bucket(grid, cell_index(grid, x[0], 0), cell_index(grid, x[1], 1), z)];
    next_[i] = first;
    first = std::int64_t(i);
  }
  grids_.push_back(std::move(grid));
}

std::int64_t ClosePairs::cell_index(const Grid& grid, double x, int axis) const {
  constexpr double farthest = 0x1p52;
  const double length = periodic_length(axis);
  if (length == 0.0) return std::int64_t(std::floor(std::clamp(x / grid.cell[axis], -farthest, farthest)));
  const double periods = (x - packing_.bounds->lower[axis]) / length;
  const double fraction = periods - std::floor(periods);
  const auto index = std::int64_t(fraction * double(grid.cells[axis]));
  return std::min(index, grid.cells[axis] - 1);
}

ClosePairs::Span ClosePairs::neighbours(const Grid& grid, double x, int axis) const {
  const std::int64_t own = cell_index(grid, x, axis);
  const std::int64_t cells = grid.cells[axis];
  if (cells == 1) return {{0, 0, 0}, 1};
  if (cells == 2) return {{0, 1, 0}, 2};
  if (cells == 0) return {{own - 1, own, own + 1}, 3};
  return {{(own + cells - 1) % cells, own, (own + 1) % cells}, 3};
}

std::size_t ClosePairs::bucket(const Grid& grid, std::int64_t x, std::int64_t y, std::int64_t z) {
  std::uint64_t hash = std::uint64_t(x) * 0x9e3779b97f4a7c15;
  hash = (std::rotl(hash, 31) ^ std::uint64_t(y)) * 0xbf58476d1ce4e5b9;
  hash = (std::rotl(hash, 31) ^ std::uint64_t(z)) * 0x94d049bb133111eb;
  return std::size_t(hash >> 32) & grid.mask;
}

double ClosePairs::distance(std::size_t i, std::size_t j) const {
  Vec3 d = packing_.bodies[j].position - packing_.bodies[i].position;
  for (int k = 0; k < packing_.dimension; ++k) {
    const double length = periodic_length(k);
    if (length > 0.0) d[k] -= length * std::round(d[k] / length);
  }
  return std::hypot(d[0], d[1], d[2]);
}

}  // namespace scree::packing
