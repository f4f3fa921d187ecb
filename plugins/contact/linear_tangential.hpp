// Parameters of a linear tangential spring with a dashpot, and of static and dynamic friction: David et al.
// (2005), [D2]-[D4].

#pragma once

#include <algorithm>

#include <scree/plugin/falling_limit.hpp>
#include <scree/plugin/stability.hpp>

namespace tangential {

struct Linear {
  double stiffness = 0;          // k_t (N/m)
  double damping = 0;            // γ_t (kg/s)
  double static_friction = 0;    // μ_s
  double dynamic_friction = -1;  // μ_d; below 0: same as static_friction
  double inverse_stiffness = 0;  // 1/k_t
  double friction_ratio = 1;     // μ_d/μ_s

  // Returns why the parameters are refused, with the cure, or null.
  const char* prepare() {
    if (dynamic_friction < 0) dynamic_friction = static_friction;
    if (dynamic_friction > 0 && static_friction == 0)
      return "dynamic_friction is above static_friction, which is 0; give static_friction too, of at least this value";
    if (dynamic_friction > static_friction)
      return "dynamic_friction is above static_friction; give at most the static value";
    if (static_friction > 0 && stiffness <= 0)
      return "friction needs tangential_stiffness above 0; give it, or static_friction = 0";
    // Its reciprocal, and the square of the time γ_t/k_t, must be finite.
    if (static_friction > 0 && !(stiffness > 1e-15 * std::max(1.0, damping)))
      return "tangential_stiffness is too small for the number format; "
             "give at least 1e-15 N/m and at least 1e-15/s times tangential_damping";
    if (stiffness > 0) inverse_stiffness = 1 / stiffness;
    if (static_friction > 0) friction_ratio = dynamic_friction / static_friction;
    return nullptr;
  }

  bool limit_falls() const { return dynamic_friction < static_friction; }

  // before: spring (m) before the step; state: that of FallingSlip, likewise.
  template <int D, class T>
  scree::FallingLimit<D, T> falling(const scree::SlipStep<D, T>& step, const T& normal_force,
                                    const scree::Vec<D, T>& normal, const scree::Vec<D, T>& before,
                                    const T& state, const T& kick) const {
    return {.step = step,
            .static_limit = T(static_friction) * normal_force,
            .ratio = T(friction_ratio),
            .before = tangential_part(before, normal),
            .state_before = state,
            .moving = kick > T(0)};
  }

  // Stiffness (N/m) and damping (kg/s) that act; 0 without friction.
  scree::Stiffness acting() const {
    return static_friction > 0 ? scree::Stiffness{stiffness, damping} : scree::Stiffness{0, 0};
  }
};

}  // namespace tangential
