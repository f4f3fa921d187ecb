#pragma once

#include "contacts/kernel/block.hpp"
#include "contacts/onset.hpp"

#include <scree/contact_kinematics.hpp>

namespace scree::kernel {

template <int N>
SCREE_HOT Vec<N> lanes_of(const double (*columns)[block_size], std::uint32_t lane) {
  Vec<N> v;
  for (int k = 0; k < N; ++k) v[k] = columns[k][lane];
  return v;
}
template <int N>
SCREE_HOT void set_lanes(double (*columns)[block_size], std::uint32_t lane, const Vec<N>& v) {
  for (int k = 0; k < N; ++k) columns[k][lane] = v[k];
}

// Normal, distance and overlap. If the centres coincide, the normal is along x.
template <int D, bool planes>
SCREE_HOT void resolve_overlaps(const double* radius_sum, std::uint32_t padded, BlockColumns& block) {
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    double distance = 0;
    const Vec<D> separation = lanes_of<D>(block.separation, i);
    if constexpr (planes) {
      distance = distance_from_plane(separation, lanes_of<D>(block.input + SCREE_NORMAL, i));
    } else {
      const PairDirection<D> direction = direction_between(separation);
      distance = direction.distance;
      for (int k = 0; k < D; ++k) block.input[SCREE_NORMAL + k][i] = direction.normal[k];
    }
    block.distance[i] = distance;
    block.input[SCREE_OVERLAP][i] = radius_sum[i] - distance;
  }
}

template <int D>
SCREE_HOT PairDirection<D> direction_of(const BlockColumns& block, std::uint32_t i) {
  return {lanes_of<D>(block.input + SCREE_NORMAL, i), block.distance[i]};
}
template <int D, bool spin>
SCREE_HOT PairStep<D> motion_of(const double (*velocity)[block_size], const double (&spins)[2][3][block_size],
                                std::uint32_t i) {
  PairStep<D> motion = {};
  motion.velocity = lanes_of<D>(velocity, i);
  if constexpr (spin) {
    motion.spin_a = lanes_of<spin_components<D>>(spins[0], i);
    motion.spin_b = lanes_of<spin_components<D>>(spins[1], i);
  }
  return motion;
}

// Motion at the contact point of a pair with a surface, whose velocity is given at the nearest point: the two
// differ by the part of the overlap that the lever arm of a leaves out, in which a wall that turns has
// another velocity.
template <int D, bool spin>
SCREE_HOT void move_to_contact_point(const PairDirection<D>& at, bool to_contact_point, double radius_sum,
                                     std::uint32_t i, const BlockColumns& block, PairStep<D>& motion) {
  if constexpr (spin) {
    const double arm =
        LeverArms<true>::of(to_contact_point, at.distance, radius_sum, block.radius_difference[i]).a;
    motion.velocity += rotational_velocity(at.normal, 0.0, at.distance - arm, motion.spin_a, motion.spin_b);
  }
}

// Tangential displacement in the step. touched: share of the step during which the pair has touched.
template <int D, bool spin, Partner partner>
SCREE_HOT void set_increment(bool to_contact_point, double radius_sum, double step, double touched,
                             std::uint32_t i, BlockColumns& block) {
  constexpr bool planes = is_wall(partner);
  PairStep<D> motion = motion_of<D, spin>(block.mid_velocity, block.mid_spin, i);
  Vec<D> separation = {};
  if constexpr (!planes)
    for (int k = 0; k < D; ++k) separation[k] = block.separation[k][i];
  PairDirection<D> end = direction_of<D>(block, i);
  if constexpr (partner == Partner::surface) end.normal = lanes_of<D>(block.mid_normal, i);
  const auto middle = mid_step_direction<planes>(end, separation, motion.velocity, step);
  if constexpr (partner == Partner::surface)
    move_to_contact_point<D, spin>(middle, to_contact_point, radius_sum, i, block, motion);
  set_lanes<D>(block.input + SCREE_TANGENTIAL_INCREMENT, i,
               tangential_increment<spin, planes>(middle, motion, to_contact_point, radius_sum,
                                                  block.radius_difference[i], step, touched));
}

// Relative velocity of the contact points, relative spin and, with `increments`, tangential displacements,
// for pairs that touch during the whole step. Returns the number of touching pairs within two steps of first
// touch or parting.
template <int D, bool spin, Partner partner, bool increments>
SCREE_HOT Count resolve_motion(bool to_contact_point, const double* radius_sum, double step, double kick,
                               std::uint32_t padded, BlockColumns& block) {
  const double longest = std::max(std::abs(step), std::abs(kick));
  Count near = 0;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    const PairDirection<D> at = direction_of<D>(block, i);
    PairStep<D> motion = motion_of<D, spin>(block.velocity, block.spin, i);
    if constexpr (partner == Partner::surface)
      move_to_contact_point<D, spin>(at, to_contact_point, radius_sum[i], i, block, motion);
    const Vec<D> v = contact_velocity<spin, is_wall(partner)>(at, motion, to_contact_point, radius_sum[i],
                                                              block.radius_difference[i]);
    if constexpr (spin)
      set_lanes<spin_components<D>>(block.input + SCREE_RELATIVE_SPIN, i, motion.spin_a - motion.spin_b);
    set_lanes<D>(block.input + SCREE_RELATIVE_VELOCITY, i, v);
    const double approach = dot(v, at.normal) * longest, overlap = block.input[SCREE_OVERLAP][i];
    near += overlap > 0 && overlap < 2 * std::abs(approach);
    if constexpr (increments)
      set_increment<D, spin, partner>(to_contact_point, radius_sum[i], step, 1, i, block);
  }
  return near;
}

// Onset weight (see OnsetWeights) of a force s steps after first touch or before parting.
SCREE_HOT double onset_weight(const OnsetWeights& weights, double s) {
  const double root = inverse_fourth_root(s);
  double power = s;  // s^(1 − p)
  for (int k = 0; k < 4; ++k) power *= k < weights.quarters ? root : 1;
  const double first = power * fused(s, fused(s, weights.first[2], weights.first[1]), weights.first[0]);
  const double second = fused(2 - s, weights.slope, 1.0);
  return s < 1 ? first : second;
}

// Corrections for pairs near first touch or parting, where w is the travel along the normal within a time:
//   touched  a pair that first touched within the step, δ < w, has touched for the fraction δ/w of the step
//   onset    weight of forces that begin or end abruptly, at s = δ/w < 2 kicks from first touch or parting
// A kick, the time for which the forces act, is as long as the step, but for the first of `position_verlet`.
// Most blocks have no such pair, and skip this.
template <int D, bool spin, Partner partner, bool increments>
SCREE_HOT void resolve_onsets(bool to_contact_point, const double* radius_sum, double step, double kick,
                              const OnsetWeights& touching, const OnsetWeights& parting, std::uint32_t padded,
                              BlockColumns& block) {
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    const Vec<D> v = lanes_of<D>(block.input + SCREE_RELATIVE_VELOCITY, i);
    const double closing_speed = -dot(v, lanes_of<D>(block.input + SCREE_NORMAL, i));
    const double overlap = block.input[SCREE_OVERLAP][i], approach = closing_speed * step;
    const double travel = std::abs(closing_speed * kick), s = overlap_share(overlap, travel);
    const double closing = onset_weight(touching, s), opening = onset_weight(parting, s);
    block.input[SCREE_ONSET_WEIGHT][i] = overlap < 2 * travel ? (approach > 0 ? closing : opening) : 1;
    const double touched = touched_share(overlap, approach);
    if constexpr (increments)
      set_increment<D, spin, partner>(to_contact_point, radius_sum[i], step, touched, i, block);
  }
}

// Radii a = √(R* δ) of Hertzian contacts, their reciprocals and roots.
SCREE_HOT void resolve_contact_radii(const double* effective_radius, std::uint32_t padded,
                                     BlockColumns& block) {
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    const double square = effective_radius[i] * std::max(block.input[SCREE_OVERLAP][i], 0.0);
    const double inverse_root = inverse_fourth_root(square), inverse = inverse_root * inverse_root;
    const double radius = square * inverse;
    block.input[SCREE_CONTACT_RADIUS][i] = radius;
    block.input[SCREE_CONTACT_RADIUS + 1][i] = inverse;
    block.input[SCREE_CONTACT_RADIUS + 2][i] = radius * inverse_root;
  }
}

// −arm n × f ± couple: torques on a and b; on a surface about the origin of its frame, such that the angular
// momentum of both is conserved.
template <int D, Partner partner, bool has_couple>
SCREE_HOT void resolve_torques(bool to_contact_point, const double* radius_sum,
                               const double* const (&force)[3], std::uint32_t padded, BlockColumns& block) {
  constexpr int S = spin_components<D>;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    Vec<D> f;
    for (int k = 0; k < D; ++k) f[k] = force[k][i];
    const Vec<S> lever = cross(lanes_of<D>(block.input + SCREE_NORMAL, i), f);
    const auto arms = LeverArms<is_wall(partner)>::of(to_contact_point, block.distance[i], radius_sum[i],
                                                      block.radius_difference[i]);
    Vec<S> of_force_on_a = {};
    if constexpr (partner == Partner::surface)
      of_force_on_a = cross(lanes_of<D>(block.lever, i) + lanes_of<D>(block.separation, i), f);
    for (int k = 0; k < S; ++k) {
      const double couple = has_couple ? block.output[SCREE_COUPLE + k][i] : 0;
      block.torque[0][k][i] = fused(-arms.a, lever[k], couple);
      block.torque[1][k][i] = partner == Partner::surface ? -of_force_on_a[k] - block.torque[0][k][i]
                                                          : fused(-arms.b, lever[k], -couple);
    }
  }
}

}  // namespace scree::kernel
