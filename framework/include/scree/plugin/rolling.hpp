#pragma once

#include <algorithm>

#include <scree/plugin/contact.hpp>
#include <scree/plugin/declaration.hpp>

namespace scree {

// Rolling friction and how fast it calms a small relative spin.
struct RollingResistance {
  double friction = 0;  // μ_r; 0: no rolling resistance
  double time = 0;      // τ_r (s); 16 steps where it is shorter

  void declare(Declaration& d) {
    d.number("rolling_friction", friction, "", non_negative, "μ_r; 0: no rolling resistance");
    d.number("rolling_time", time, "s", non_negative,
             "time constant of a small spin of a sphere with the pair's reduced mass and effective radius "
             "(two equal spheres: 4 times as long); at least 16 steps");
  }
};

// Rolling resistance: a constant torque μ_r f R* against the relative spin Δω [L7], with R* as in the code
// that Lemrich et al. used. Near Δω = 0 the torque is limited to −I* Δω/τ, where I* = 0.4 m* R*² is the
// inertia of a sphere of the pair's reduced mass and radius: a dashpot, whose result converges with the step.
// τ >= 16 steps, so that bodies at rest do not jitter, with a dozen contacts and with any integrator.
// spring_force: elastic part of the normal force (N). Sets the couple and the dissipated power of `out`.
template <int D, class T, std::uint32_t reads>
void resist_rolling(const Contact<D, T, reads>& c, const T& spring_force, RollingResistance rolling,
                    LawOutput<D, T, true>& out) {
  const T square_spin = dot(c.relative_spin, c.relative_spin);
  const T full = T(rolling.friction) * spring_force * c.effective_radius;
  const T root = c.reduced_mass_root * c.effective_radius;
  const T step = c.step < T(0) ? -c.step : c.step;
  const T time = std::max(T(16) * step, T(rolling.time));
  const T bound = T(0.4) * root * root * (T(1) / std::max(time, smallest_divisor<T>));
  const T torque_by_spin = std::min(full * inverse_sqrt(square_spin), bound);
  out.couple = -torque_by_spin * c.relative_spin;
  out.dissipation_rate_rolling = torque_by_spin * square_spin;
}

}  // namespace scree
