#pragma once

#include "contacts/kernel/block.hpp"
#include "contacts/onset.hpp"

#include <scree/plugin/roots.hpp>

namespace scree::kernel {

template <int N, class T>
SCREE_HOT Vec<N, T> lanes_of(const T (*columns)[block_size], std::uint32_t lane) {
  Vec<N, T> v;
  for (int k = 0; k < N; ++k) v[k] = columns[k][lane];
  return v;
}
template <int N, class T>
SCREE_HOT void set_lanes(T (*columns)[block_size], std::uint32_t lane, const Vec<N, T>& v) {
  for (int k = 0; k < N; ++k) columns[k][lane] = v[k];
}

// n × (arm_a ω_a + arm_b ω_b): contribution of the spins to the velocity of a's contact point relative to b's
// (equation 2 of David et al., see plugins/contact/linear_spring_dashpot.cpp).
template <int D, class T>
SCREE_HOT Vec<D, T> rotational_velocity(const Vec<D, T>& n, const T& arm_a, const T& arm_b,
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
template <bool planes, class T>
struct Arms {
  T a, b;
  SCREE_HOT static Arms of(bool to_contact_point, const T& distance, const T& radius_sum,
                           const T& difference) {
    const T reach = to_contact_point ? distance : radius_sum;
    if constexpr (planes) return {T(0.5) * (reach + difference), T(0)};
    return {T(0.5) * (reach + difference), T(0.5) * (reach - difference)};
  }
};

// Normal, distance and overlap. If the centres coincide, the normal is along x.
template <int D, bool planes, class T>
SCREE_HOT void resolve_overlaps(const double* radius_sum, std::uint32_t padded, BlockColumns<T>& block) {
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    double distance = 0;
    const Vec<D> separation = lanes_of<D>(block.separation, i);
    if constexpr (planes) {
      for (int k = 0; k < D; ++k)
        distance = fused(separation[k], double(block.input[SCREE_NORMAL + k][i]), distance);
    } else {
      const Root<double> length = length_of(separation);
      distance = length.value;
      const bool apart = distance > 0;
      for (int k = 0; k < D; ++k)
        block.input[SCREE_NORMAL + k][i] = T(k == 0 && !apart ? 1.0 : separation[k] * length.inverse);
    }
    block.distance[i] = T(distance);
    block.input[SCREE_OVERLAP][i] = T(radius_sum[i] - distance);
  }
}

// Tangential displacement in the step, perpendicular to the mid-step normal. touched: fraction of the step
// during which the pair has touched.
template <int D, bool spin, bool planes, class T>
SCREE_HOT void set_increment(bool to_contact_point, const T& radius_sum, double step, const T& touched,
                             std::uint32_t i, BlockColumns<T>& block) {
  constexpr int S = spin_components<D>;
  const T h = T(step), half = T(0.5 * step);
  const Vec<D, T> motion = lanes_of<D>(block.mid_velocity, i), n = lanes_of<D>(block.input + SCREE_NORMAL, i);
  Vec<D, T> mid_normal = n, slip = motion;
  T distance = block.distance[i];
  if constexpr (planes) {
    distance = fused(-half, dot(motion, n), distance);
  } else {
    Vec<D, T> separation;
    for (int k = 0; k < D; ++k) separation[k] = fused(-half, motion[k], T(block.separation[k][i]));
    const T square = dot(separation, separation), inverse = inverse_sqrt(square);
    distance = square * inverse;
    for (int k = 0; k < D; ++k) mid_normal[k] = separation[k] * inverse;
  }
  if constexpr (spin) {
    const auto arms = Arms<planes, T>::of(to_contact_point, distance, radius_sum, block.radius_difference[i]);
    slip += rotational_velocity(mid_normal, arms.a, arms.b, lanes_of<S>(block.mid_spin[0], i),
                                lanes_of<S>(block.mid_spin[1], i));
  }
  set_lanes<D>(block.input + SCREE_TANGENTIAL_INCREMENT, i,
               (h * touched) * tangential_part(slip, mid_normal));
}

// Relative velocity of the contact points, relative spin and, with `increments`, tangential displacements,
// for pairs that touch during the whole step. Returns the number of touching pairs within two steps of first
// touch or parting.
template <int D, bool spin, bool planes, bool increments, class T>
SCREE_HOT Count<T> resolve_motion(bool to_contact_point, const double* radius_sum, double step, double kick,
                                  std::uint32_t padded, BlockColumns<T>& block) {
  constexpr int S = spin_components<D>;
  const T longest = std::max(T(std::abs(step)), T(std::abs(kick)));
  Count<T> near = 0;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    const Vec<D, T> n = lanes_of<D>(block.input + SCREE_NORMAL, i);
    Vec<D, T> v = lanes_of<D>(block.velocity, i);
    if constexpr (spin) {
      const auto arms = Arms<planes, T>::of(to_contact_point, block.distance[i], T(radius_sum[i]),
                                            block.radius_difference[i]);
      const Vec<S, T> spin_a = lanes_of<S>(block.spin[0], i), spin_b = lanes_of<S>(block.spin[1], i);
      v += rotational_velocity(n, arms.a, arms.b, spin_a, spin_b);
      set_lanes<S>(block.input + SCREE_RELATIVE_SPIN, i, spin_a - spin_b);
    }
    set_lanes<D>(block.input + SCREE_RELATIVE_VELOCITY, i, v);
    const T approach = dot(v, n) * longest, overlap = block.input[SCREE_OVERLAP][i];
    near += overlap > T(0) && overlap < T(2) * std::abs(approach);
    if constexpr (increments)
      set_increment<D, spin, planes>(to_contact_point, T(radius_sum[i]), step, T(1), i, block);
  }
  return near;
}

// Onset weight (see OnsetWeights) of a force s steps after first touch or before parting.
template <class T>
SCREE_HOT T onset_weight(const OnsetWeights& weights, const T& s) {
  const T root = inverse_fourth_root(s);
  T power = s;  // s^(1 − p)
  for (int k = 0; k < 4; ++k) power *= k < weights.quarters ? root : T(1);
  const T first = power * fused(s, fused(s, T(weights.first[2]), T(weights.first[1])), T(weights.first[0]));
  const T second = fused(T(2) - s, T(weights.slope), T(1));
  return s < T(1) ? first : second;
}

// Corrections for pairs near first touch or parting, where w is the travel along the normal within a time:
//   touched  a pair that first touched within the step, δ < w, has touched for the fraction δ/w of the step
//   onset    weight of forces that begin or end abruptly, at s = δ/w < 2 kicks from first touch or parting
// A kick, the time for which the forces act, is as long as the step, but for the first of `position_verlet`.
// Most blocks have no such pair, and skip this.
template <int D, bool spin, bool planes, bool increments, class T>
SCREE_HOT void resolve_onsets(bool to_contact_point, const double* radius_sum, double step, double kick,
                              const OnsetWeights& touching, const OnsetWeights& parting, std::uint32_t padded,
                              BlockColumns<T>& block) {
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    const Vec<D, T> v = lanes_of<D>(block.input + SCREE_RELATIVE_VELOCITY, i);
    const T closing_speed = -dot(v, lanes_of<D>(block.input + SCREE_NORMAL, i));
    const T overlap = block.input[SCREE_OVERLAP][i], approach = closing_speed * T(step);
    const auto part_of = [&](const T& travel) SCREE_INLINE_LAMBDA {  // δ/w
      return std::max(overlap, T(0)) * (T(1) / (travel > T(0) ? travel : T(1)));
    };
    const T travel = std::abs(closing_speed * T(kick)), s = part_of(travel);
    const T closing = onset_weight(touching, s), opening = onset_weight(parting, s);
    block.input[SCREE_ONSET_WEIGHT][i] =
        overlap < T(2) * travel ? (approach > T(0) ? closing : opening) : T(1);
    const T touched = overlap < approach ? part_of(approach) : T(1);
    if constexpr (increments)
      set_increment<D, spin, planes>(to_contact_point, T(radius_sum[i]), step, touched, i, block);
  }
}

// Radii a = √(R* δ) of Hertzian contacts, their reciprocals and roots.
template <class T>
SCREE_HOT void resolve_contact_radii(const T* effective_radius, std::uint32_t padded,
                                     BlockColumns<T>& block) {
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    const T square = effective_radius[i] * std::max(block.input[SCREE_OVERLAP][i], T(0));
    const T inverse_root = inverse_fourth_root(square), inverse = inverse_root * inverse_root;
    const T radius = square * inverse;
    block.input[SCREE_CONTACT_RADIUS][i] = radius;
    block.input[SCREE_CONTACT_RADIUS + 1][i] = inverse;
    block.input[SCREE_CONTACT_RADIUS + 2][i] = radius * inverse_root;
  }
}

// −arm n × f ± couple: torques on a and b.
template <int D, bool planes, bool has_couple, class T>
SCREE_HOT void resolve_torques(bool to_contact_point, const double* radius_sum, const T* const (&force)[3],
                               std::uint32_t padded, BlockColumns<T>& block) {
  constexpr int S = spin_components<D>;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i) {
    Vec<D, T> f;
    for (int k = 0; k < D; ++k) f[k] = force[k][i];
    const Vec<S, T> lever = cross(lanes_of<D>(block.input + SCREE_NORMAL, i), f);
    const auto arms = Arms<planes, T>::of(to_contact_point, block.distance[i], T(radius_sum[i]),
                                          block.radius_difference[i]);
    for (int k = 0; k < S; ++k) {
      const T couple = has_couple ? block.output[SCREE_COUPLE + k][i] : T(0);
      block.torque[0][k][i] = fused(-arms.a, lever[k], couple);
      block.torque[1][k][i] = fused(-arms.b, lever[k], -couple);
    }
  }
}

}  // namespace scree::kernel
