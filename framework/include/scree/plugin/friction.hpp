#pragma once

#include <algorithm>
#include <type_traits>

#include <scree/plugin/contact_law.hpp>

namespace scree {

// Coulomb friction of a contact with a tangential spring and a dashpot beside it, as a continuous law:
//   ξ′ = v_t − s                   spring (m), carried along with the tangent plane; s velocity of slip
//   |k ξ| < C:  s = 0              it sticks
//   |k ξ| = C:  s = σ ξ/|ξ|, σ >= 0 such that |k ξ| = C holds as C changes: it slides
//   f_t = −P(k ξ + γ v_t)          P(f): the vector nearest to f that is not longer than C
// The force of the spring alone makes the spring slip; the dashpot never does, and is limited so that the sum
// obeys Coulomb's law. Both lose energy only: k ξ · s = C σ >= 0, and (P(k ξ + γ v) − k ξ) · v >= 0, for k ξ
// = P(k ξ) and a projection is monotone.

// A tangential contact after a step.
template <int D, class T>
struct Slip {
  Vec<D, T> spring;  // ξ (m)
  Vec<D, T> force;   // f_t (N)
  bool slides;
};

// What a step is ended with.
template <int D, class T>
struct SlipStep {
  const Vec<D, T>& moved;          // ξ moved by the step, in the present tangent plane (m)
  T stiffness, inverse_stiffness;  // k and 1/k at its end (N/m, m/N)
  const Vec<D, T>& velocity;       // v_t at its end (m/s)
  T delay;                         // γ/k, weighted around first touch (s)
  T length;                        // of the step (s)
  T limit, sliding_limit;          // C as the contact has been so far, and while it slides (N)
};

// The direction of slip turns within the step, from that of the old spring towards that of v_t: a return
// along the moved spring alone lags by half a step. To second order, and whatever the size of the step, the
// direction is that of p = ξ + ½ y h v_t, with y = slip/|ξ| = ½ (ξ²/L² − 1), L = C/k. It is multiplied by 4
// L², which saves a division. The whole force is along k ξ + γ v_t = (C/|p|) (p + |p| γ/C v_t), where |p| = ½
// L (1 + ξ²/L²) to second order does without the root that ξ waits for.
// damped: false saves what a dashpot takes.
template <bool damped = true, int D, class T>
inline Slip<D, T> slide_or_stick(const SlipStep<D, T>& in) {
  const T longest = in.limit * in.inverse_stiffness, square = dot(in.moved, in.moved);
  const bool slides = square > longest * longest;
  const T sliding_longest = in.sliding_limit * in.inverse_stiffness;  // L
  const T longest_square = sliding_longest * sliding_longest;

  // In single precision 4 L² times p, squared, would be too small a number.
  T scale = T(1);
  if constexpr (std::is_same_v<T, float>) scale = T(1) / std::max(square, smallest_divisor<T>);
  const T kept = slides ? T(4) * scale * longest_square : T(1);
  const T turned = slides ? scale * in.length * (square - longest_square) : T(0);
  const Vec<D, T> direction = fused(turned, in.velocity, kept * in.moved);
  const T shortening = sliding_longest * inverse_sqrt(dot(direction, direction));
  const T share = slides ? shortening : T(1), whole = in.stiffness * share;
  if constexpr (!damped) return {share * direction, -whole * direction, slides};

  const T limit = slides ? in.sliding_limit : in.limit;
  const T length = slides ? T(2) * scale * (square + longest_square) : T(1);  // |direction|/L
  const Vec<D, T> along = fused(in.delay * length, in.velocity, direction);
  const T along_square = dot(along, along), limiting = limit * inverse_sqrt(along_square);
  const bool limited = whole * whole * along_square > limit * limit;
  return {share * direction, -(limited ? limiting : whole) * along, slides};
}

// The rule of David et al. (2005) as printed: the test force k ξ + γ v_t decides on slip [D3], and while the
// contact slides the spring is ξ = −(f_t + γ v_t)/k [D4], so that f_t has the direction of the test force.
// Where γ v_t changes during slip this moves energy between dashpot and spring, and may create some. Limits
// and dashpot have no weights around first touch here, for the spring makes up for a dashpot that the next
// step adds with another weight.
//   onset_weight                             of dashpots around first touch
//   weighted_limit, weighted_sliding_limit   C with that weight, which the force obeys (N)
template <int D, class T>
inline Slip<D, T> slide_or_stick_by_total(const SlipStep<D, T>& in, const T& onset_weight,
                                          const T& weighted_limit, const T& weighted_sliding_limit) {
  const T damping = in.stiffness * in.delay;
  const Vec<D, T> test = fused(in.stiffness, in.moved, damping * in.velocity);
  const T square = dot(test, test), limit_square = in.limit * in.limit;
  const bool slides = square > limit_square;
  const T ratio = std::min(square / std::max(limit_square, smallest_divisor<T>), T(1e4));
  const T turned = slides ? T(0.25) * (ratio - T(1)) * in.length * in.stiffness : T(0);
  const Vec<D, T> direction = fused(turned, in.velocity, test);
  const T shortening = in.sliding_limit * inverse_sqrt(dot(direction, direction));
  const Vec<D, T> held = (slides ? shortening : T(1)) * direction;  // k ξ + γ v_t

  const T missing = slides ? T(0) : (onset_weight - T(1)) * damping;
  const Vec<D, T> whole = fused(missing, in.velocity, direction);
  const T limit = slides ? weighted_sliding_limit : weighted_limit, whole_square = dot(whole, whole);
  const T limiting = limit * inverse_sqrt(whole_square);
  const T share = slides || whole_square > limit * limit ? limiting : T(1);
  return {in.inverse_stiffness * fused(-damping, in.velocity, held), -share * whole, slides};
}

}  // namespace scree
