#include "bodies/body_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <scree/body_order.hpp>
#include <scree/spatial_order.hpp>

namespace scree {

namespace {

constexpr int bits_per_axis = 21;

// Spreads the lowest 21 bits so that two zero bits follow each of them.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

Vec3 lower_corner(std::span<const Sphere> bodies) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Vec3 lower = {{infinite, infinite, infinite}};
  for (const Sphere& body : bodies)
    for (int k = 0; k < 3; ++k) lower[k] = std::min(lower[k], body.position[k] - body.radius);
  return lower;
}

// Axis along which the listed bodies are farthest apart.
int longest_side(std::span<const Sphere> bodies, int dimension, std::span<const std::uint32_t> listed) {
  int longest = 0;
  double length = -1;
  for (int k = 0; k < dimension; ++k) {
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
      return bodies[a].position[k] < bodies[b].position[k];
    };
    const auto [first, last] = std::minmax_element(listed.begin(), listed.end(), before);
    const double side = bodies[*last].position[k] - bodies[*first].position[k];
    if (side > length) longest = k, length = side;
  }
  return longest;
}

// Cuts the bodies in two across their longest side, at the end of a tile, and so on down to tiles. These are
// compact, so that few pairs are between them. Bodies of a tile are in the order of their rank.
void sort_into_tiles(std::span<const Sphere> bodies, const std::vector<std::uint32_t>& rank, int dimension,
                     std::span<std::uint32_t> order) {
  const std::size_t tiles = BodyTiles(order.size()).count();
  if (tiles == 1) {
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return rank[a] < rank[b]; });
    return;
  }
  const int axis = longest_side(bodies, dimension, order);
  const auto along = [&](std::uint32_t a, std::uint32_t b) {
    const double x = bodies[a].position[axis], y = bodies[b].position[axis];
    return x < y || (x == y && rank[a] < rank[b]);
  };
  const std::size_t middle = tiles / 2 * BodyTiles::usual_size;
  std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(middle), order.end(), along);
  sort_into_tiles(bodies, rank, dimension, order.first(middle));
  sort_into_tiles(bodies, rank, dimension, order.subspan(middle));
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Sphere> bodies, int dimension) {
  std::vector<std::uint32_t> order(bodies.size());
  std::iota(order.begin(), order.end(), 0u);
  const Vec3 lower = lower_corner(bodies);
  double width = 0;
  for (const Sphere& body : bodies) width += 2 * body.radius / double(bodies.size());
  const double last_cell = std::exp2(bits_per_axis) - 1;
  std::vector<std::uint64_t> code(bodies.size(), 0);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (int k = 0; k < dimension; ++k) {
      const double cell = std::floor((bodies[i].position[k] - lower[k]) / width);
      code[i] |= spread(std::uint64_t(std::clamp(cell, 0.0, last_cell))) << k;
    }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return code[a] < code[b]; });
  if (BodyTiles(bodies.size()).count() > 1) sort_into_tiles(bodies, inverse_of(order), dimension, order);
  return order;
}

std::vector<std::uint32_t> spatial_order(const std::vector<Body>& bodies, int dimension) {
  std::vector<Sphere> spheres;
  for (const Body& body : bodies) spheres.push_back({body.position, body.radius});
  return spatial_order(spheres, dimension);
}

}  // namespace scree
