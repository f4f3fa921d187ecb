#pragma once

#include <cmath>

namespace scree {

// Longest stable step of velocity Verlet (s) for x″ = −ω² x − g x′, where g sees the predicted velocity: the
// step at which an eigenvalue of the map reaches −1, ω² h²/4 + g h = 1.
// stiffness_over_mass: ω² (1/s²), damping_over_mass: g (1/s).
inline double critical_step(double stiffness_over_mass, double damping_over_mass) {
  const double g = damping_over_mass;
  return 2 / (std::sqrt(g * g + stiffness_over_mass) + g);
}

// Of a contact with these squared frequencies and damping rates along its normal and along its surface: of a
// pair alone the shorter of the two; in a network that is so many times stiffer both work on the same bodies.
struct Stiffness {
  double over_mass, damping_over_mass;  // (1/s²), (1/s)
};
inline double critical_step(const Stiffness& normal, const Stiffness& tangential, double network) {
  if (network > 1)
    return critical_step(network * (normal.over_mass + tangential.over_mass),
                         network * (normal.damping_over_mass + tangential.damping_over_mass));
  const double along = critical_step(normal.over_mass, normal.damping_over_mass);
  const double across = critical_step(tangential.over_mass, tangential.damping_over_mass);
  return along < across ? along : across;
}

// How much lighter a contact is along the surface, where bodies also turn, than along the normal, for arms of
// a full radius: 1 + m R²/I, 7/2 for spheres; discs have 3.
inline constexpr double tangential_lightness = 3.5;

}  // namespace scree
