#pragma once

#include "impact.hpp"

namespace reference {

// The damping ratio with which a head-on impact has this restitution; the same for both kinds of law.
double damping_ratio(double restitution, Tension tension);

// A law as it acts between two given bodies: its forces as functions of the overlap.
class Coefficients {
 public:
  Coefficients(const Law& law, double effective_mass, double effective_radius);

  bool hertz() const { return law_.kind == LawKind::hertz; }
  const Law& law() const { return law_; }
  double elastic_force(double overlap) const;
  double elastic_force_slope(double overlap) const;
  double elastic_energy(double overlap) const;
  // Force over velocity of the normal dashpot, and its derivative with respect to the overlap.
  double normal_damping(double overlap) const;
  double normal_damping_slope(double overlap) const;
  double tangential_stiffness(double overlap) const;
  double tangential_stiffness_slope(double overlap) const;
  double tangential_damping(double overlap) const;
  // Duration of the head-on impact, apart from the exact effect of damping.
  double duration(double approach_speed) const;

 private:
  Law law_;
  double effective_mass_;
  double damping_ratio_ = 0;
  // What multiplies the power of the overlap in each of the forces above.
  double elastic_ = 0, normal_damping_ = 0, tangential_ = 0, tangential_damping_ = 0;
};

}  // namespace reference
