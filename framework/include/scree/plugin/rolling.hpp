#pragma once

#include <algorithm>

#include <scree/plugin/contact.hpp>

namespace scree {

// Rolling resistance: a constant torque μ_r f R* against the relative spin Δω [L7], with R* as in the code
// that Lemrich et al. used. Near Δω = 0 the torque is limited to the value that removes 1/16 of the relative
// spin of a sphere of the pair's reduced mass and radius within the step, so that bodies at rest do not
// jitter, with a dozen contacts and with any integrator. spring_force: elastic part of the normal force (N).
// Sets the couple and the dissipated power of `out`.
template <int D, class T, std::uint32_t reads>
void resist_rolling(const Contact<D, T, reads>& c, const T& spring_force, double rolling_friction,
                    Response<D, T, true>& out) {
  const T square_spin = dot(c.relative_spin, c.relative_spin);
  const T full = T(rolling_friction) * spring_force * c.effective_radius;
  const T root = c.reduced_mass_root * c.effective_radius;
  const T step = c.step < T(0) ? -c.step : c.step;
  const T bound = T(0.4) * root * root * (T(1.0 / 16) / std::max(step, smallest_divisor<T>));
  const T torque_by_spin = std::min(full * inverse_sqrt(square_spin), bound);
  out.couple = -torque_by_spin * c.relative_spin;
  out.dissipation_rate_rolling = torque_by_spin * square_spin;
}

}  // namespace scree
