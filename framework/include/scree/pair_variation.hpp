#pragma once

#include <array>

#include <scree/plugin/vec.hpp>

namespace scree {

using Matrix3 = std::array<Vec3, 3>;  // by rows

inline Matrix3& operator+=(Matrix3& sum, const Matrix3& more) {
  for (std::size_t k = 0; k < 3; ++k) sum[k] += more[k];
  return sum;
}
// factor v vᵀ.
inline Matrix3 outer_square(double factor, const Vec3& v) {
  return {factor * v[0] * v, factor * v[1] * v, factor * v[2] * v};
}
// factor (1 − n nᵀ).
inline Matrix3 across(double factor, const Vec3& n) {
  Matrix3 matrix = outer_square(-factor, n);
  for (int k = 0; k < 3; ++k) matrix[std::size_t(k)][k] += factor;
  return matrix;
}

// Components xx, yy, zz, xy, xz, yz of a symmetric matrix, as SCREE_NORMAL_CHANGE.
inline std::array<double, 6> symmetric_components(const Matrix3& m) {
  return {m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]};
}

// How a pair changes while the centre of a moves and its partner does not.
struct PairVariation {
  Matrix3 normal = {};         // (1/m) derivative of the normal, row k of its component k; symmetric
  Vec3 effective_radius = {};  // (1) derivative of R*
  std::array<Vec3, 6> normal_change = {};  // (1/m²) of a surface: derivative of symmetric_components(normal)

  // Of two bodies whose centres have this distance: (1 − n nᵀ)/d. Of a plane 0.
  static PairVariation of_bodies(const Vec3& normal, double distance) {
    return {across(1 / distance, normal), {}, {}};
  }
};

}  // namespace scree
