// Arcs along a surface between the contact and a point painted on it, from the derivative H of the normal
// with the place of the body (Contact::normal_change) alone. Exact on flats, straight edges, cylinders and
// spheres; on cones and rims the third order of the angles between the two points is left out.

#pragma once

#include <algorithm>

#include <scree/plugin/contact.hpp>
#include <scree/plugin/roots.hpp>

namespace tangential {

// From a painted point to the contact (m), with tan²(φ/2) of the angle φ by which the surface bends between.
template <class T>
struct SurfaceArc {
  scree::Vec<3, T> arc;
  T bend;
};

template <class T>
class SurfaceArcs {
 public:
  using Vector = scree::Vec<3, T>;

  // flat: height above the tangent plane that is round-off (m).
  SurfaceArcs(const scree::Vec<6, T>& h, const T& flat) : h_(h), flat_square_(flat * flat) {
    const T square =
        scree::fused(T(2), h[3] * h[3] + h[4] * h[4] + h[5] * h[5], h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    const T trace = h[0] + h[1] + h[2], inverse = T(1) / std::max(square, scree::smallest_divisor<T>);
    across_ = trace * inverse;
    roundness_ = (trace * trace - square) * inverse;
  }

  // H v: how the normal turns as the body moves.
  Vector turn(const Vector& v) const {
    using scree::fused;
    return {{fused(h_[0], v[0], fused(h_[3], v[1], h_[4] * v[2])),
             fused(h_[3], v[0], fused(h_[1], v[1], h_[5] * v[2])),
             fused(h_[4], v[0], fused(h_[5], v[1], h_[2] * v[2]))}};
  }

  // from: c − B (m), c: nearest point of the surface, B: painted point. On a circle the chord is R sin φ and
  // the height R (1 − cos φ) = R sin φ tan(φ/2), so that with u = tan²(φ/2)
  //   R φ = R sin φ (1 + u) atan(√u)/√u
  // The part of the chord along which the surface bends becomes longer, the rest is straight.
  SurfaceArc<T> between(const Vector& from, const Vector& normal) const {
    const T height = dot(from, normal);
    const Vector chord = tangential_part(from, normal), bent = across_ * turn(chord);
    const T square = std::max(dot(chord, bent), T(0)) + flat_square_;
    const T u = std::min(height * height / square, T(most_bend));
    const T stretch = u * scree::detail::polynomial(u, 2.0 / 3, -2.0 / 15, 2.0 / 35, -2.0 / 63, 2.0 / 99,
                                                    -2.0 / 143, 2.0 / 195);
    return {fused(stretch, bent, chord), u};
  }

  // What an arc b on a sphere resists a shift of the contact less across than along, relative to the shift:
  // 1 − φ cot φ, over b² (1/m²). On a surface that can be unrolled 0.
  T shear(const SurfaceArc<T>& b) const {
    const T of_sphere = b.bend * scree::detail::polynomial(b.bend, 4.0 / 3, -8.0 / 15, 12.0 / 35, -16.0 / 63,
                                                           20.0 / 99, -24.0 / 143, 28.0 / 195);
    return roundness_ * of_sphere / (dot(b.arc, b.arc) + flat_square_);
  }

  // Gaussian curvature (1/m²) along an arc b: φ²/b² on a sphere.
  T gaussian_curvature(const SurfaceArc<T>& b) const {
    const T square_of_sphere =
        b.bend * scree::detail::polynomial(b.bend, 4.0, -8.0 / 3, 92.0 / 45, -176.0 / 105);
    return roundness_ * square_of_sphere / (dot(b.arc, b.arc) + flat_square_);
  }

 private:
  static constexpr double most_bend = 0.01;  // φ = 0.2: laws paint anew before

  const scree::Vec<6, T>& h_;
  T flat_square_;
  T across_;     // (m) makes H the projection onto the directions in which the surface bends
  T roundness_;  // 1: a sphere, 0: bent in one direction
};

}  // namespace tangential
