#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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
  return order;
}

std::vector<std::uint32_t> spatial_order(const std::vector<Body>& bodies, int dimension) {
  std::vector<Sphere> spheres;
  for (const Body& body : bodies) spheres.push_back({body.position, body.radius});
  return spatial_order(spheres, dimension);
}

}  // namespace scree
