#pragma once

#include <scree/integrator.hpp>

namespace scree {

// Velocity Verlet in two halves around the force evaluation:
//   v(t + h/2) = v(t) + h/2 F(t)/m,  x(t + h) = x(t) + h v(t + h/2)    drift, predicting v(t) + h F(t)/m
//   v(t + h) = v(t + h/2) + h/2 F(t + h)/m                             kick
class VelocityVerlet : public Integrator {
 public:
  double drift(Particles& particles, double step, BodyRange bodies) override;
  bool kick(Particles& particles, double step, BodyRange bodies) override;
  Moved kick_and_drift(Particles& particles, double step, double next, BodyRange bodies) override;
};

// Five steps of velocity Verlet, the third back in time, whose errors of third order cancel:
// p h, p h, (1 − 4p) h, p h, p h with p = 1/(4 − 4^(1/3)); M. Suzuki, Phys. Lett. A 146, 319 (1990).
class FourthOrder : public VelocityVerlet {
 public:
  std::span<const double> substeps() const override;
};

// Position Verlet, whose forces are taken in mid-step:
//   x(t + h/2) = x(t) + h/2 v(t)                                       drift, predicting v(t) + h/2 F/m
//   v(t + h) = v(t) + h F(t + h/2)/m,  x(t + h) = x(t + h/2) + h/2 v(t + h)   kick
class PositionVerlet : public Integrator {
 public:
  bool evaluates_at_mid_step() const override { return true; }
  double drift(Particles& particles, double step, BodyRange bodies) override;
  bool kick(Particles& particles, double step, BodyRange bodies) override;
};

}  // namespace scree
