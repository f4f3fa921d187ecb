#pragma once

#include <cmath>

namespace scree {

// Longest stable step of velocity Verlet (s) for x″ = −ω² x − g x′, where damping acts on the predicted
// velocity: the step h at which an eigenvalue of the step map reaches −1, ω² h²/4 + g h = 1.
// stiffness_over_mass: ω² (1/s²), damping_over_mass: g (1/s).
inline double critical_step(double stiffness_over_mass, double damping_over_mass) {
  const double g = damping_over_mass;
  return 2 / (std::sqrt(g * g + stiffness_over_mass) + g);
}

// Stiffness and damping of a contact in one direction, divided by its effective mass: (1/s²), (1/s).
struct Stiffness {
  double over_mass, damping_over_mass;
};

// Longest stable step (s) of a contact. For an isolated pair (network = 1) the shorter step of the normal and
// the tangential motion; in a network `network` times stiffer than the pair both add up, since they act on
// the same bodies.
inline double critical_step(const Stiffness& normal, const Stiffness& tangential, double network) {
  if (network > 1)
    return critical_step(network * (normal.over_mass + tangential.over_mass),
                         network * (normal.damping_over_mass + tangential.damping_over_mass));
  const double along = critical_step(normal.over_mass, normal.damping_over_mass);
  const double across = critical_step(tangential.over_mass, tangential.damping_over_mass);
  return along < across ? along : across;
}

// Ratio of normal to tangential effective mass, since a tangential force also turns the bodies: 1 + m R²/I
// with arms of a full radius, 7/2 for spheres; 3 for discs.
inline constexpr double tangential_inverse_mass = 3.5;

}  // namespace scree
