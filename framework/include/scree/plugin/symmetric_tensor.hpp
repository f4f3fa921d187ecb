#pragma once

#include <array>
#include <cmath>
#include <utility>

#include <scree/plugin/vec.hpp>

namespace scree {

// Symmetric tensor of second order; in two dimensions zz, xz and yz are 0.
struct SymmetricTensor {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  // Adds the symmetric part of weight a ⊗ b.
  void add(double weight, const Vec3& a, const Vec3& b) {
    xx += weight * a[0] * b[0];
    yy += weight * a[1] * b[1];
    zz += weight * a[2] * b[2];
    xy += 0.5 * weight * (a[0] * b[1] + a[1] * b[0]);
    xz += 0.5 * weight * (a[0] * b[2] + a[2] * b[0]);
    yz += 0.5 * weight * (a[1] * b[2] + a[2] * b[1]);
  }
  void scale(double factor) {
    for (double* component : {&xx, &yy, &zz, &xy, &xz, &yz}) *component *= factor;
  }
  // As numbers in this order, such as totals of a probe.
  static constexpr unsigned count = 6;
  void add_to(double* sums) const {
    for (const double component : {xx, yy, zz, xy, xz, yz}) *sums++ += component;
  }
  static SymmetricTensor of(const double* sums) {
    return {sums[0], sums[1], sums[2], sums[3], sums[4], sums[5]};
  }
  // Mean of the normal components.
  double mean(int dimension) const { return (xx + yy + zz) / dimension; }
};

// Principal values of a symmetric tensor, the largest first, and the direction of the first, whose largest
// component is above 0.
struct PrincipalValues {
  std::array<double, 3> values = {};
  Vec3 major = {};
};

namespace detail {

// One rotation of Jacobi's method, after which the component (p, q) is 0. rows: (3, 3); vectors: (3, 3),
// columns.
inline void rotate(double (&rows)[3][3], double (&vectors)[3][3], int p, int q) {
  if (rows[p][q] == 0) return;
  const double theta = (rows[q][q] - rows[p][p]) / (2 * rows[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (int k = 0; k < 3; ++k) {
    const double kp = rows[k][p], kq = rows[k][q];
    rows[k][p] = c * kp - s * kq;
    rows[k][q] = s * kp + c * kq;
  }
  for (int k = 0; k < 3; ++k) {
    const double pk = rows[p][k], qk = rows[q][k];
    rows[p][k] = c * pk - s * qk;
    rows[q][k] = s * pk + c * qk;
    const double vp = vectors[k][p], vq = vectors[k][q];
    vectors[k][p] = c * vp - s * vq;
    vectors[k][q] = s * vp + c * vq;
  }
}

}  // namespace detail

// In two dimensions there are two values, and the third is 0.
inline PrincipalValues principal_values(const SymmetricTensor& t, int dimension) {
  double rows[3][3] = {{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}};
  double vectors[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr int sweeps = 12;  // the method converges quadratically
  for (int n = 0; n < sweeps; ++n)
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}})
      if (q < dimension) detail::rotate(rows, vectors, p, q);
  int order[3] = {0, 1, 2};
  for (const auto& [i, k] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 1}})
    if (k < dimension && rows[order[i]][order[i]] < rows[order[k]][order[k]]) std::swap(order[i], order[k]);
  PrincipalValues result;
  for (int k = 0; k < dimension; ++k) result.values[std::size_t(k)] = rows[order[k]][order[k]];
  int largest = 0;
  for (int k = 0; k < dimension; ++k) {
    result.major[k] = vectors[k][order[0]];
    if (std::abs(result.major[k]) > std::abs(result.major[largest])) largest = k;
  }
  if (result.major[largest] < 0) result.major = -result.major;
  return result;
}

// √(½((σ₁ − σ₂)² + (σ₂ − σ₃)² + (σ₃ − σ₁)²)) in three dimensions, (σ₁ − σ₂)/2 in two.
inline double deviator(const PrincipalValues& principal, int dimension) {
  const auto& [a, b, c] = principal.values;
  if (dimension == 2) return 0.5 * (a - b);
  return std::sqrt(0.5 * ((a - b) * (a - b) + (b - c) * (b - c) + (c - a) * (c - a)));
}

}  // namespace scree
