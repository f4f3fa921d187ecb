#pragma once

#include <scree/plugin/friction.hpp>

namespace scree {

// Coulomb friction whose limit falls as slip begins: C_s = μ_s f_n in stick, C_d = μ_d f_n < C_s in slip. The
// spring then shortens at once from L_s = C_s/k to L_d = C_d/k, and the force jumps; with a dashpot it jumps
// again as slip ends, where P's limit rises from C_d to C_s (P: see friction.hpp).
//
// The sum of the forces at the ends of steps counts a force that jumps within a step as constant up to
// mid-step. The impulse that this misses is added to the force at the end of the step, so that it is exact to
// second order wherever in the step the jump is.
//   Slip begins at the fraction θ of a step, where e = |ξ| − L_s is 0; linear from e₀ before the step to e₁ after it
//   without slip, θ = −e₀/(e₁ − e₀). The spring falls from L_s to L_d there, and slips for the rest of the step.
//     added to f_t: −(θ − ½) j,  j = P_s(C_s d + γ v_t) − P_d(C_d d + γ v_t),  d = ξ/|ξ|
//   Where L_d falls faster than the spring shortens, it sticks at once: P_s in both terms.
//   Slip ends where its velocity is 0. In a step the spring slips by S = |ξ| − L_d, ξ without slip; linear between the
//   middles of the last two steps, S₀ > 0 > S, the velocity was 0 the fraction u = S/(S − S₀) of a step before the
//   middle of the last one.
//     added to f_t: −u j,  j = P_s(k ξ + γ v_t) − P_d(k ξ + γ v_t)

// Input: a contact before slip is applied.
template <int D, class T>
struct FallingLimit {
  SlipStep<D, T> step;  // its limit is not used
  T static_limit;       // C_s (N)
  T ratio;              // μ_d/μ_s
  Vec<D, T> before;     // ξ₀, in the present tangent plane (m)
  T state_before;       // S₀ > 0 while sliding, e₀ <= 0 while sticking (m)
  bool moving;          // whether the force acts on the bodies for a step, and not at one configuration only
};

// Result.
template <int D, class T>
struct FallingSlip {
  Slip<D, T> slip;  // its force with what the end of slip adds; slides: whether the spring has slipped
  Vec<D, T> begun;  // what the begin of slip adds to the force (N)
  T state;          // S > 0 while sliding, e <= 0 while sticking (m)
};

namespace detail {

// P(f): f, limited to the magnitude `limit`.
template <int D, class T>
inline Vec<D, T> limited(const Vec<D, T>& f, const T& limit) {
  const T square = dot(f, f), limiting = limit * inverse_sqrt(square);
  return (square > limit * limit ? limiting : T(1)) * f;
}

// The moment within a step at which slip begins.
template <int D, class T>
struct SlipBegin {
  bool slid, begins;    // before the step; in it
  T theta;              // θ
  T longest;            // L_s at θ (m)
  Vec<D, T> direction;  // d at θ
};

// length, longest: |ξ| without slip and L_s at the end of the step (m).
template <int D, class T>
inline SlipBegin<D, T> begin_of_slip(const FallingLimit<D, T>& in, const T& length_before, const T& length,
                                     const T& longest) {
  const bool slid = in.state_before > T(0);
  const T e_0 = std::min(in.state_before, T(0)), e_1 = length - longest;
  const T theta = std::min(-e_0 / std::max(e_1 - e_0, smallest_divisor<T>), T(1));
  const T longest_before = length_before - e_0;
  const Vec<D, T> then = fused(theta, in.step.trial_spring - in.before, in.before);
  const bool begins = !slid & (e_1 > T(0));  // with && loops do not vectorise
  return {slid, begins, theta, fused(theta, longest - longest_before, longest_before),
          inverse_sqrt(dot(then, then)) * then};
}

// j as slip begins, with `after` for the limit of P beyond it (N).
template <int D, class T>
inline Vec<D, T> jump_of(const Vec<D, T>& direction, const T& static_limit, const T& ratio, const T& after,
                         const Vec<D, T>& dashpot) {
  return limited(fused(static_limit, direction, dashpot), static_limit) -
         limited(fused(ratio * static_limit, direction, dashpot), after);
}

}  // namespace detail

// Returns spring, force and state after slip. damped = false: compiled without the dashpot.
template <bool damped = true, int D, class T>
inline FallingSlip<D, T> slide_or_stick(const FallingLimit<D, T>& in) {
  const SlipStep<D, T>& step = in.step;
  const T length_before = length_of(in.before).value, length = length_of(step.trial_spring).value;
  const T longest = in.static_limit * step.inverse_stiffness;
  const detail::SlipBegin<D, T> begin = detail::begin_of_slip(in, length_before, length, longest);
  const T fall = begin.begins ? (in.ratio - T(1)) * begin.longest : T(0);
  const Vec<D, T> fallen = fused(fall, begin.direction, step.trial_spring);
  // e decides on the begin of slip; without it no spring is beyond a limit of twice its length.
  const T held_limit = std::max(in.static_limit, T(2) * step.stiffness * length);
  const T limit = (begin.slid | begin.begins) ? step.sliding_limit : held_limit;
  Slip<D, T> slip = slide_or_stick<damped>(SlipStep<D, T>{fallen, step.stiffness, step.inverse_stiffness,
                                                          step.velocity, step.delay, step.step, limit,
                                                          step.sliding_limit, step.stretching, step.returns});
  const bool sticks = !slip.slides;  // also where the spring has fallen and not slipped after that
  slip.slides = begin.begins | !sticks;
  const T before_middle = (begin.begins & in.moving) ? T(0.5) - begin.theta : T(0);
  const T limit_then = step.stiffness * begin.longest, sliding_limit_then = in.ratio * limit_then;
  const T excess = std::min(length_of(slip.spring).value - longest, T(0));
  if constexpr (!damped)
    return {slip, (before_middle * (limit_then - sliding_limit_then)) * begin.direction,
            sticks ? excess : T(1)};

  const Vec<D, T> dashpot = (step.stiffness * step.delay) * step.velocity;
  const Vec<D, T> jump = detail::jump_of(begin.direction, limit_then, in.ratio,
                                         sticks ? limit_then : sliding_limit_then, dashpot);
  const T slipped = length_of(fallen).value - step.sliding_limit * step.inverse_stiffness;  // S
  const T over = std::min(slipped - in.state_before, -smallest_divisor<T>);
  const T late = (begin.slid & in.moving) ? slipped / over : T(0);  // u, where slip has ended
  const Vec<D, T> whole = fused(step.stiffness, slip.spring, dashpot);
  const Vec<D, T> held = detail::limited(whole, in.static_limit);
  const Vec<D, T> stuck = fused(late, held - detail::limited(whole, step.sliding_limit), held);
  for (int k = 0; k < D; ++k) {  // clang makes a branch where ?: reads an element
    const T ending = -stuck[k], sliding = slip.force[k];
    slip.force[k] = sticks ? ending : sliding;
  }
  return {slip, before_middle * jump, sticks ? excess : std::max(slipped, smallest_divisor<T>)};
}

}  // namespace scree
