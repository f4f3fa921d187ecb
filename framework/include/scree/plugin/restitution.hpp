#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scree/plugin/vec.hpp>

namespace scree {

// Whether the normal force may become attractive through its dashpot at the end of a contact. allowed: the
// contact ends at δ = 0; cut: it ends earlier, at f_n = 0.
enum class Tension { allowed, cut };

// Coefficient of restitution of a contact that obeys v dv/dy = −ω₀² y − 2ζω₀ v: a linear spring and dashpot
// with y = δ; also a Hertzian contact with a dashpot ∝ δ^(1/4), where y = (4/5) δ^(5/4) and ω₀² = 5k/(4m*).
//   tension allowed: r = exp(−πζ/√(1−ζ²))
//   tension cut:     r = exp(−ζφ/√(1−ζ²)), φ = atan2(2ζ√(1−ζ²), 2ζ²−1), the phase at which the force vanishes
inline double restitution_of(double zeta, Tension tension) {
  constexpr double pi = std::numbers::pi;
  const double root = std::sqrt(std::max(1 - zeta * zeta, 0.0));
  if (tension == Tension::allowed) return root > 0 ? std::exp(-pi * zeta / root) : 0;
  if (zeta < 1) return std::exp(-zeta / root * std::atan2(2 * zeta * root, 2 * zeta * zeta - 1));
  const double overdamped = std::sqrt(zeta * zeta - 1);
  if (overdamped == 0) return std::exp(-2.0);
  return std::exp(-zeta / overdamped * std::log((zeta + overdamped) / (zeta - overdamped)));
}

// The damping ratio ζ that gives a coefficient of restitution in (0, 1].
inline double damping_ratio_of(double restitution, Tension tension) {
  constexpr double pi = std::numbers::pi;
  if (restitution == 1) return 0;
  if (tension == Tension::allowed) {
    const double log_r = std::log(restitution);
    return -log_r / std::sqrt(pi * pi + log_r * log_r);
  }
  double low = 0, high = 1;
  while (restitution_of(high, tension) > restitution && high < 1e6) high *= 2;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (restitution_of(middle, tension) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Correction factor for the predicted normal velocity in a dashpot. The prediction v + h F/m with the force
// before the step overshoots by −½ h² F'/m = ½ h² (K/m*) v, K being the stiffness of the contact itself, so
// that a damped impact would dissipate too much by the relative amount ½ (ω h)²; the factor removes this
// error. Other contacts of the same bodies are not considered: their error is of second order.
//   half_square_step  ½ h² (s²);  stiffness  K = dF/dδ (N/m)
template <class T>
inline T prediction_share(const T& half_square_step, const T& stiffness, const T& reduced_mass_root) {
  const T mass = reduced_mass_root * reduced_mass_root;
  return mass / fused(half_square_step, stiffness, mass);
}

}  // namespace scree
