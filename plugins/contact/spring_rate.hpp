// Rate of path-independent tangential springs of discs, [M24] and [M25], and of spheres whose painted points
// are at the contact.

#pragma once

#include <scree/plugin/vec.hpp>

namespace tangential {

// D_t′ = α v·t − R_a ω_a − R_b ω_b, α = (R_a + R_b)/|x_a − x_b| (beside a wall 1), as
//   D_t′ = α V_t + e (ω_a − ω_b),   e = δ (R_a − R_b)/(2 |x_a − x_b|) (beside a wall −δ/2),
// where V_t has arms to the contact point, R − δ/2. The generalised forces of T = k_t D_t are −α T along t on
// a and torques T R_a, T R_b [M30]; those of −α T with these arms differ by the couple −e T on a, e T on b.
template <class T>
struct SpringRate {
  T stretch;           // α
  T offset;            // e (m)
  T inverse_distance;  // 1/|x_a − x_b| (1/m), beside a wall 0

  template <class AnyContact>
  static SpringRate of(const AnyContact& c) {
    const bool wall = c.at_surface || c.radius_b == T(0);
    const T sum = c.radius_a + c.radius_b, inverse = T(1) / (sum - c.overlap);
    return {wall ? T(1) : sum * inverse,
            T(0.5) * c.overlap * (wall ? T(-1) : (c.radius_a - c.radius_b) * inverse), wall ? T(0) : inverse};
  }
  T operator()(const T& along_tangent, const T& relative_turning) const {
    return scree::fused(stretch, along_tangent, offset * relative_turning);
  }
  // ξ′ of spheres: α V_t + e (ω_a − ω_b) × n.
  scree::Vec<3, T> operator()(const scree::Vec<3, T>& tangential, const scree::Vec<3, T>& relative_turning,
                              const scree::Vec<3, T>& normal) const {
    return fused(stretch, tangential, offset * cross(relative_turning, normal));
  }
};

}  // namespace tangential
