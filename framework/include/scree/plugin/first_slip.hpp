#pragma once

#include <scree/plugin/falling_limit.hpp>

namespace scree {

// Slip that begins soon after first touch, of a spring without dashpot under a Coulomb limit that jumps
// there, to C₀, as the normal force jumps with its dashpot. Friction grows as k v t until it reaches the
// limit. If that takes about a step, the sum over samples misses the ramp and the kink at its end, up to
// half of C₀ h of impulse: an error of first order until steps resolve the ramp. It is added to the force
// at the end of the step in which slip begins. With first touch s steps and slip s' steps before,
//   s < 1:       w C − ½ (s − s') C₀ in place of C; w: onset weight, in this step and the next
//   1 <= s < 2:  C + ½ a' s' (1 − s') − ½ a σ (1 − σ),  σ = s − 1
// with slopes (N a step) a = k v h of the ramp at first touch and a' of |k ξ| − C where slip begins: the
// Euler-Maclaurin terms ½ B₂ of kinks between samples. Both are exact for a ramp to a constant C₀, and agree
// where slip begins at s = 1. Sticking is decided without onset weight.

// Input: a contact before slip is applied.
template <int D, class T>
struct FirstSlip {
  SlipStep<D, T> step;  // limits with the onset weight
  T limit;              // C without it (N)
  T jump;               // C₀ (N), 0 or less: none
  T growth, slowing;    // C grows in a step with the overlap, and falls as the bodies are braked (N)
  T touching;           // overlap/(velocity × step), very large unless the bodies approach
  Vec<D, T> before;     // ξ before the step (m)
  bool slid, moving;    // before the step; see FallingLimit
};

namespace detail {

// What is added to the force along the spring as slip begins (N). travel: v h (m).
template <int D, class T>
inline T added_as_slip_begins(const FirstSlip<D, T>& in, const T& excess, const T& travel) {
  const T k = in.step.stiffness, length_before = length_of(in.before).value;
  const T late = std::max(in.jump + excess, smallest_divisor<T>);
  const T at_once = in.step.limit - in.limit - T(0.5) * in.touching * in.jump * in.jump / late;
  // Steps from first touch to the last sample, by the spring.
  const T earlier = length_before / std::max(travel, smallest_divisor<T>);
  // That sample's force had the onset weight, and braked the bodies by as much.
  const T limit_before = in.limit - in.growth + std::min(T(1.5) * earlier, T(1)) * in.slowing;
  const T missing = std::max(limit_before - k * length_before, T(0));
  const T kink = T(0.5) * excess * missing / std::max(excess + missing, smallest_divisor<T>);
  const T part = std::min(earlier, T(1));
  const T ramp = T(0.5) * k * travel * part * (T(1) - part);
  return in.touching < T(1) ? at_once : kink - ramp;
}

}  // namespace detail

// Returns spring and force after slip; `state` is 1 while the contact slides, else 0.
template <bool damped = true, int D, class T>
inline FallingSlip<D, T> slide_or_stick(const FirstSlip<D, T>& in) {
  // With && loops do not vectorise.
  const bool early = in.touching<T(2), jumps = in.jump> T(0), soon = early & jumps & !in.slid;
  SlipStep<D, T> step = in.step;
  step.limit = soon ? in.limit : in.step.limit;
  step.sliding_limit = soon ? in.limit : in.step.sliding_limit;
  const Slip<D, T> slip = slide_or_stick<damped>(step);
  const Root<T> length = length_of(step.trial_spring);
  const T travel = step.step * dot(step.stretching, step.trial_spring) * length.inverse;
  const T excess = step.stiffness * length.value - in.limit;
  const T added = detail::added_as_slip_begins(in, excess, travel);
  const T acting = (soon & slip.slides & in.moving) ? added : T(0);
  return {slip, (-acting * length.inverse) * step.trial_spring, slip.slides ? T(1) : T(0)};
}

}  // namespace scree
