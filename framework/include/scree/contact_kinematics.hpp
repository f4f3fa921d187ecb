#pragma once

#include <algorithm>

#include <scree/plugin/roots.hpp>
#include <scree/plugin/vec.hpp>

// Kinematics of one touching pair: what a contact law reads follows from positions, motions and radii. The
// kernel evaluates it for blocks of pairs at vector width, static equilibria and linear response for single
// pairs. The partner b of body a is a body or a plane (`plane`); the normal points from b to a. T: double or
// float.

namespace scree {

// Of kernel functions, whose loops are vectorised only if everything is inlined.
#define SCREE_KINEMATICS [[gnu::always_inline]] inline

// n × (arm_a ω_a + arm_b ω_b): contribution of the spins to the velocity of a's contact point relative to b's
// (equation 2 of David et al., see plugins/contact/linear_spring_dashpot.cpp). Rotations (rad) give a
// displacement.
template <int D, class T>
SCREE_KINEMATICS Vec<D, T> rotational_velocity(const Vec<D, T>& n, const T& arm_a, const T& arm_b,
                                               const Vec<spin_components<D>, T>& spin_a,
                                               const Vec<spin_components<D>, T>& spin_b) {
  const auto spin = fused(arm_a, spin_a, arm_b * spin_b);
  if constexpr (D == 2)
    return -cross(spin, n);
  else
    return cross(n, spin);
}

// Lever arms from the centres to the contact point (m), R − δ/2 or R; 0 for a plane. With s = R_a + R_b and
// δ = s − distance, R_a − δ/2 = (distance + R_a − R_b)/2 and R_b − δ/2 = (distance − R_a + R_b)/2.
template <bool plane, class T>
struct LeverArms {
  T a, b;
  SCREE_KINEMATICS static LeverArms of(bool to_contact_point, const T& distance, const T& radius_sum,
                                       const T& difference) {
    const T reach = to_contact_point ? distance : radius_sum;
    if constexpr (plane) return {T(0.5) * (reach + difference), T(0)};
    return {T(0.5) * (reach + difference), T(0.5) * (reach - difference)};
  }
};

// Where a is, seen from b.
template <int D, class T>
struct PairDirection {
  Vec<D, T> normal;
  T distance;  // (m) between the centres, or from the plane to the centre
};

// Of two bodies, by x_a − x_b (m). If the centres coincide, the normal is along x.
template <int D>
SCREE_KINEMATICS PairDirection<D, double> direction_between(const Vec<D>& separation) {
  const Root<double> length = length_of(separation);
  const bool apart = length.value > 0;
  PairDirection<D, double> direction;
  direction.distance = length.value;
  for (int k = 0; k < D; ++k) direction.normal[k] = k == 0 && !apart ? 1.0 : separation[k] * length.inverse;
  return direction;
}

// Distance (m) from a plane, by x_a minus a point of the plane (m).
template <int D, class T>
SCREE_KINEMATICS double distance_from_plane(const Vec<D>& separation, const Vec<D, T>& normal) {
  double distance = 0;
  for (int k = 0; k < D; ++k) distance = fused(separation[k], double(normal[k]), distance);
  return distance;
}

// Motion of a pair during a step, constant in it. Displacements (m), (rad) are velocities for a step of 1.
template <int D, class T>
struct PairStep {
  Vec<D, T> velocity;                         // of a's centre relative to b's (m/s)
  Vec<spin_components<D>, T> spin_a, spin_b;  // (rad/s)
};

// The direction in the middle of a step (s) that ends at `end`, with x_a − x_b (m) there.
template <bool plane, int D, class T>
SCREE_KINEMATICS PairDirection<D, T> mid_step_direction(const PairDirection<D, T>& end,
                                                        const Vec<D, T>& separation,
                                                        const Vec<D, T>& velocity, double step) {
  const T half = T(0.5 * step);
  PairDirection<D, T> middle = end;
  if constexpr (plane) {
    middle.distance = fused(-half, dot(velocity, end.normal), end.distance);
  } else {
    Vec<D, T> between;
    for (int k = 0; k < D; ++k) between[k] = fused(-half, velocity[k], separation[k]);
    const T square = dot(between, between), inverse = inverse_sqrt(square);
    middle.distance = square * inverse;
    for (int k = 0; k < D; ++k) middle.normal[k] = between[k] * inverse;
  }
  return middle;
}

// Velocity of a's contact point relative to b's (m/s).
template <bool spin, bool plane, int D, class T>
SCREE_KINEMATICS Vec<D, T> contact_velocity(const PairDirection<D, T>& at, const PairStep<D, T>& motion,
                                            bool to_contact_point, const T& radius_sum, const T& difference) {
  Vec<D, T> velocity = motion.velocity;
  if constexpr (spin) {
    const auto arms = LeverArms<plane, T>::of(to_contact_point, at.distance, radius_sum, difference);
    velocity += rotational_velocity(at.normal, arms.a, arms.b, motion.spin_a, motion.spin_b);
  }
  return velocity;
}

// Tangential displacement (m) in a step (s), perpendicular to the normal in its middle. touched: share of the
// step during which the pair has touched.
template <bool spin, bool plane, int D, class T>
SCREE_KINEMATICS Vec<D, T> tangential_increment(const PairDirection<D, T>& middle,
                                                const PairStep<D, T>& motion, bool to_contact_point,
                                                const T& radius_sum, const T& difference, double step,
                                                const T& touched) {
  const Vec<D, T> slip =
      contact_velocity<spin, plane>(middle, motion, to_contact_point, radius_sum, difference);
  return (T(step) * touched) * tangential_part(slip, middle.normal);
}

// Overlap over a travel along the normal (m): δ/w.
template <class T>
SCREE_KINEMATICS T overlap_share(const T& overlap, const T& travel) {
  return std::max(overlap, T(0)) * (T(1) / (travel > T(0) ? travel : T(1)));
}

// Share of a step during which a pair touches that approaches by a distance (m) in it.
template <class T>
SCREE_KINEMATICS T touched_share(const T& overlap, const T& approach) {
  return overlap < approach ? overlap_share(overlap, approach) : T(1);
}

// Reduced mass (kg) and effective radius (m) of a pair; a plane has an inverse mass and a curvature of 0.
inline double reduced_mass(double inverse_mass_a, double inverse_mass_b) {
  return 1 / (inverse_mass_a + inverse_mass_b);
}
inline double effective_radius(double radius_a, double radius_b, bool plane) {
  return plane ? radius_a : 1 / (1 / radius_a + 1 / radius_b);
}

#undef SCREE_KINEMATICS

}  // namespace scree
