#include "lattice_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::packing {

namespace {

constexpr double row_height = std::numbers::sqrt3 / 2.0;  // of a triangular layer
constexpr double square_layer_height = std::numbers::sqrt2 / 2.0;
const double triangular_layer_height = std::sqrt(2.0 / 3.0);

double half_if_odd(std::int64_t index) { return index % 2 == 0 ? 0.0 : 0.5; }

}  // namespace

Vec3 lattice_step(LatticeKind kind) {
  switch (kind) {
    case LatticeKind::face_centred_cubic:
      return {{1.0, 1.0, square_layer_height}};
    case LatticeKind::hexagonal_close:
      return {{1.0, row_height, triangular_layer_height}};
    case LatticeKind::triangular:
      return {{1.0, row_height, 1.0}};
    default:
      return {{1.0, 1.0, 1.0}};
  }
}

Vec3 lattice_site(LatticeKind kind, const SiteCount& index) {
  Vec3 site = lattice_step(kind);
  for (int axis = 0; axis < 3; ++axis) site[axis] *= double(index[axis]);
  const auto [i, j, k] = index;
  if (kind == LatticeKind::triangular) site[0] += half_if_odd(j);
  if (kind == LatticeKind::hexagonal_close) {
    site[0] += half_if_odd(j + k);
    site[1] += half_if_odd(k) * row_height * 2.0 / 3.0;
  }
  if (kind == LatticeKind::face_centred_cubic) {
    site[0] += half_if_odd(k);
    site[1] += half_if_odd(k);
  }
  return site;
}

Vec3 lattice_extent(LatticeKind kind, const SiteCount& count) {
  Vec3 extent{};
  for (std::int64_t j = 0; j < std::min<std::int64_t>(2, count[1]); ++j) {
    for (std::int64_t k = 0; k < std::min<std::int64_t>(2, count[2]); ++k) {
      const Vec3 site = lattice_site(kind, {count[0] - 1, count[1] - 1 - j, count[2] - 1 - k});
      for (int axis = 0; axis < 3; ++axis) extent[axis] = std::max(extent[axis], site[axis]);
    }
  }
  return extent;
}

std::array<bool, 3> staggered_axes(LatticeKind kind) {
  return {false, kind == LatticeKind::triangular || kind == LatticeKind::hexagonal_close,
          kind == LatticeKind::hexagonal_close || kind == LatticeKind::face_centred_cubic};
}

SiteCount nearest_count(LatticeKind kind, std::int64_t total, const std::array<bool, 3>& periodic) {
  const int dimension = lattice_dimension(kind);
  const Vec3 step = lattice_step(kind);
  const auto staggered = staggered_axes(kind);
  double volume = double(total);
  for (int k = 0; k < dimension; ++k) volume *= step[k];
  const double edge = dimension == 3 ? std::cbrt(volume) : std::sqrt(volume);
  SiteCount count = {1, 1, 1};
  std::int64_t layer = 1;
  for (int k = 0; k < dimension; ++k) {
    const bool even = periodic[k] && staggered[k];
    const bool last = k == dimension - 1;
    count[k] = last ? (total + layer - 1) / layer : std::max<std::int64_t>(1, std::llround(edge / step[k]));
    if (even) count[k] += count[k] % 2;
    layer *= count[k];
  }
  return count;
}

}  // namespace scree::packing
