#pragma once

#include <algorithm>

#include <scree/plugin/roots.hpp>
#include <scree/plugin/vec.hpp>

// Kinematics of one touching pair: what a contact law reads follows from positions, motions and radii. The
// kernel evaluates it for blocks of pairs at vector width, static equilibria and linear response for single
// pairs. The partner b of body a is a body or a plane (`plane`); the normal points from b to a.

namespace scree {

// Of kernel functions, whose loops are vectorised only if everything is inlined.
#define SCREE_KINEMATICS [[gnu::always_inline]] inline

// n × (arm_a ω_a + arm_b ω_b): contribution of the spins to the velocity of a's contact point relative to b's
// (equation 2 of David et al., see plugins/contact/linear_spring_dashpot.cpp). Rotations (rad) give a
// displacement.
template <int D>
SCREE_KINEMATICS Vec<D> rotational_velocity(const Vec<D>& n, double arm_a, double arm_b,
                                            const Vec<spin_components<D>>& spin_a,
                                            const Vec<spin_components<D>>& spin_b) {
  const auto spin = fused(arm_a, spin_a, arm_b * spin_b);
  if constexpr (D == 2)
    return -cross(spin, n);
  else
    return cross(n, spin);
}

// Lever arms from the centres to the contact point (m), R − δ/2 or R; 0 for a plane. With s = R_a + R_b and
// δ = s − distance, R_a − δ/2 = (distance + R_a − R_b)/2 and R_b − δ/2 = (distance − R_a + R_b)/2.
template <bool plane>
struct LeverArms {
  double a, b;
  SCREE_KINEMATICS static LeverArms of(bool to_contact_point, double distance, double radius_sum,
                                       double difference) {
    const double reach = to_contact_point ? distance : radius_sum;
    if constexpr (plane) return {0.5 * (reach + difference), 0};
    return {0.5 * (reach + difference), 0.5 * (reach - difference)};
  }
};

// Where a is, seen from b.
template <int D>
struct PairDirection {
  Vec<D> normal;
  double distance;  // (m) between the centres, or from the plane to the centre
};

// Of two bodies, by x_a − x_b (m). If the centres coincide, the normal is along x.
template <int D>
SCREE_KINEMATICS PairDirection<D> direction_between(const Vec<D>& separation) {
  const Root<double> length = length_of(separation);
  const bool apart = length.value > 0;
  PairDirection<D> direction;
  direction.distance = length.value;
  for (int k = 0; k < D; ++k) direction.normal[k] = k == 0 && !apart ? 1.0 : separation[k] * length.inverse;
  return direction;
}

// Distance (m) from a plane, by x_a minus a point of the plane (m).
template <int D>
SCREE_KINEMATICS double distance_from_plane(const Vec<D>& separation, const Vec<D>& normal) {
  double distance = 0;
  for (int k = 0; k < D; ++k) distance = fused(separation[k], normal[k], distance);
  return distance;
}

// Motion of a pair during a step, constant in it. Displacements (m), (rad) are velocities for a step of 1.
template <int D>
struct PairStep {
  Vec<D> velocity;                         // of a's centre relative to b's (m/s)
  Vec<spin_components<D>> spin_a, spin_b;  // (rad/s)
};

// The direction in the middle of a step (s) that ends at `end`, with x_a − x_b (m) there.
template <bool plane, int D>
SCREE_KINEMATICS PairDirection<D> mid_step_direction(const PairDirection<D>& end, const Vec<D>& separation,
                                                     const Vec<D>& velocity, double step) {
  const double half = 0.5 * step;
  PairDirection<D> middle = end;
  if constexpr (plane) {
    middle.distance = fused(-half, dot(velocity, end.normal), end.distance);
  } else {
    Vec<D> between;
    for (int k = 0; k < D; ++k) between[k] = fused(-half, velocity[k], separation[k]);
    const double square = dot(between, between), inverse = inverse_sqrt(square);
    middle.distance = square * inverse;
    for (int k = 0; k < D; ++k) middle.normal[k] = between[k] * inverse;
  }
  return middle;
}

// Velocity of a's contact point relative to b's (m/s).
template <bool spin, bool plane, int D>
SCREE_KINEMATICS Vec<D> contact_velocity(const PairDirection<D>& at, const PairStep<D>& motion,
                                         bool to_contact_point, double radius_sum, double difference) {
  Vec<D> velocity = motion.velocity;
  if constexpr (spin) {
    const auto arms = LeverArms<plane>::of(to_contact_point, at.distance, radius_sum, difference);
    velocity += rotational_velocity(at.normal, arms.a, arms.b, motion.spin_a, motion.spin_b);
  }
  return velocity;
}

// Tangential displacement (m) in a step (s), perpendicular to the normal in its middle. touched: share of the
// step during which the pair has touched.
template <bool spin, bool plane, int D>
SCREE_KINEMATICS Vec<D> tangential_increment(const PairDirection<D>& middle, const PairStep<D>& motion,
                                             bool to_contact_point, double radius_sum, double difference,
                                             double step, double touched) {
  const Vec<D> slip = contact_velocity<spin, plane>(middle, motion, to_contact_point, radius_sum, difference);
  return (step * touched) * tangential_part(slip, middle.normal);
}

// Overlap over a travel along the normal (m): δ/w.
SCREE_KINEMATICS double overlap_share(double overlap, double travel) {
  return std::max(overlap, 0.0) * (1 / (travel > 0 ? travel : 1));
}

// Share of a step during which a pair touches that approaches by a distance (m) in it.
SCREE_KINEMATICS double touched_share(double overlap, double approach) {
  return overlap < approach ? overlap_share(overlap, approach) : 1;
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
