#pragma once

#include <algorithm>

#include <scree/plugin/contact.hpp>

namespace scree {

// Coulomb friction of a contact with a tangential spring and a parallel dashpot, in continuous time:
//   ξ′ = v_t − s                   spring elongation ξ (m) in the rotating tangent plane; s: slip velocity
//   |k ξ| < C:  s = 0              stick
//   |k ξ| = C:  s = σ ξ/|ξ|, σ >= 0 such that |k ξ| = C holds as C changes: slip
//   f_t = −P(k ξ + γ v_t)          P(f): projection of f onto the ball of radius C, the Coulomb limit
// The spring slips when its own force reaches the limit; the dashpot never causes slip, and is limited so
// that the sum obeys Coulomb's law. Both can only dissipate: k ξ · s = C σ >= 0, and
// (P(k ξ + γ v) − k ξ) · v >= 0, because k ξ = P(k ξ) and a projection onto a convex set is monotone.

// Result: tangential spring and force at the end of a step.
template <int D, class T>
struct Slip {
  Vec<D, T> spring;  // ξ (m)
  Vec<D, T> force;   // f_t (N)
  bool slides;
};

// Input: tangential state of a contact before slip is applied.
template <int D, class T>
struct SlipStep {
  const Vec<D, T>& trial_spring;   // ξ plus the displacement of the step, in the present tangent plane (m)
  T stiffness, inverse_stiffness;  // k and 1/k at the end of the step (N/m, m/N)
  const Vec<D, T>& velocity;       // v_t at the end of the step (m/s)
  T delay;                         // γ/k, with the onset weight (s)
  T step;                          // (s)
  T limit, sliding_limit;          // C for the previous state (stick or slip), and C for slip (N)
  // ξ′ + s at the end of the step (m/s): v_t, unless the spring stretches at another velocity than its
  // dashpot.
  const Vec<D, T>& stretching = velocity;
  // Whether the step goes backwards in time from where the contact slides.
  bool returns = false;
};

// Direction of a spring that returns through slip: kept ξ + turned (ξ′ + s), of `length` L.
template <class T>
struct Returned {
  T kept, turned, length;
};
template <int D, class T>
inline Returned<T> returned(const SlipStep<D, T>& in, const T& square) {
  const T moved = in.step * dot(in.stretching, in.trial_spring);  // h v·ξ
  const T moved_square = in.step * in.step * dot(in.stretching, in.stretching);
  const T along = moved - moved_square, later_square = square - moved - along;  // h v·b, b²
  return {later_square - along, in.step * along, later_square};
}

// Returns spring and force after slip. The slip direction turns within the step, from the direction of the
// old spring towards ξ′ + s: a radial return of the trial spring ξ alone lags by half a step. To second order
// in the step h, and for any amount of slip, the new spring has the direction of
//   p = ξ + ½ y h (ξ′ + s),   y = slip/|ξ| = ½ (ξ²/L² − 1),   L = C/k;
// the code computes 4 L² p, which saves a division. The total force is along
//   k ξ + γ v_t = (C/|p|) (p + |p| γ/C v_t),   |p| = ½ L (1 + ξ²/L²) to second order,
// which avoids waiting for the square root. damped = false: compiled without the dashpot.
//
// Backwards in time a slipping spring does not let go but stays at the limit of the earlier time. To
// second order it has the direction of b + h (v − (v·b)/b² b), v = ξ′ + s, with b = ξ − h v the spring
// at the later time and h < 0; the code computes b² times that.
template <bool damped = true, int D, class T>
inline Slip<D, T> slide_or_stick(const SlipStep<D, T>& in) {
  const T longest = in.limit * in.inverse_stiffness, square = dot(in.trial_spring, in.trial_spring);
  const bool slides = (square > longest * longest) | in.returns;
  const T sliding_longest = in.sliding_limit * in.inverse_stiffness;  // L
  const T longest_square = sliding_longest * sliding_longest;
  const Returned<T> back = returned(in, square);
  const T kept = in.returns ? back.kept : slides ? T(4) * longest_square : T(1);
  const T turned = in.returns ? back.turned : slides ? in.step * (square - longest_square) : T(0);
  const Vec<D, T> direction = fused(turned, in.stretching, kept * in.trial_spring);
  const T shortening = sliding_longest * inverse_sqrt(dot(direction, direction));
  const T share = slides ? shortening : T(1), whole = in.stiffness * share;
  if constexpr (!damped) return {share * direction, -whole * direction, slides};

  const T limit = slides ? in.sliding_limit : in.limit;
  const T length = in.returns ? back.length
                   : slides   ? T(2) * (square + longest_square)
                              : T(1);  // |direction|/L
  const Vec<D, T> along = fused(in.delay * length, in.velocity, direction);
  const T along_square = dot(along, along), limiting = limit * inverse_sqrt(along_square);
  const bool limited = whole * whole * along_square > limit * limit;
  return {share * direction, -(limited ? limiting : whole) * along, slides};
}

// The rule of David et al. (2005) as printed: the test force k ξ + γ v_t decides on slip [D3], and during
// slip the spring is ξ = −(f_t + γ v_t)/k [D4], so that f_t has the direction of the test force. Where γ v_t
// changes during slip, energy moves between dashpot and spring, and some may be created. `in` holds limits
// and dashpot without onset weights: during slip the spring absorbs the dashpot force, whose weight changes
// in the next step.
//   onset_weight                             of the dashpot
//   weighted_limit, weighted_sliding_limit   C with that weight: limit of the returned force (N)
template <int D, class T>
inline Slip<D, T> slide_or_stick_by_total(const SlipStep<D, T>& in, const T& onset_weight,
                                          const T& weighted_limit, const T& weighted_sliding_limit) {
  const T damping = in.stiffness * in.delay;
  const Vec<D, T> test = fused(in.stiffness, in.trial_spring, damping * in.velocity);
  const T square = dot(test, test), limit_square = in.limit * in.limit;
  const bool slides = square > limit_square;
  const T ratio = std::min(square / std::max(limit_square, smallest_divisor<T>), T(1e4));
  const T turned = slides ? T(0.25) * (ratio - T(1)) * in.step * in.stiffness : T(0);
  const Vec<D, T> direction = fused(turned, in.stretching, test);
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
