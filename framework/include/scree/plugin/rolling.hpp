#pragma once

#include <algorithm>

#include <scree/plugin/contact_law.hpp>

namespace scree {

// Rolling resistance of constant torque against the relative spin, μ_r f R* [L7], with R* as in the code that
// Lemrich et al. used. Towards Δω = 0 the torque is bounded by what would take a sixteenth of the relative
// spin of a sphere of the pair's mass and radius within the step: a body at rest is not shaken, with a dozen
// contacts and whatever the integrator. spring_force: elastic part of the normal force (N). Sets the couple
// and the dissipated power.
template <int D, class T>
void resist_rolling(const Contact<D, T>& c, const T& spring_force, double rolling_friction,
                    Response<D, T>& out) {
  const T square_rate = dot(c.relative_spin, c.relative_spin);
  const T full = T(rolling_friction) * spring_force * c.effective_radius;
  const T root = c.reduced_mass_root * c.effective_radius;
  const T step = c.step < T(0) ? -c.step : c.step;
  const T bound = T(0.4) * root * root * (T(1.0 / 16) / std::max(step, smallest_divisor<T>));
  const T torque_by_rate = std::min(full * inverse_sqrt(square_rate), bound);
  out.couple = -torque_by_rate * c.relative_spin;
  out.dissipated_rolling = torque_by_rate * square_rate;
}

}  // namespace scree
