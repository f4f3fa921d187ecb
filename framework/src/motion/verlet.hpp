#pragma once

#include "motion/integrator.hpp"

namespace scree {

// Velocity Verlet, in two halves around the force evaluation:
//   v(t + h/2) = v(t) + h/2 F(t)/m,  x(t + h) = x(t) + h v(t + h/2)    begin_step, predicting v(t) + h F(t)/m
//   v(t + h) = v(t + h/2) + h/2 F(t + h)/m                             finish_step
class VelocityVerlet : public Integrator {
 public:
  double begin_step(Particles& particles, double step, BodyRange bodies) override;
  bool finish_step(Particles& particles, double step, BodyRange bodies) override;
  Moved finish_and_begin_step(Particles& particles, double step, double next, BodyRange bodies) override;
};

// Five substeps of velocity Verlet, the third backwards in time, whose third-order errors cancel:
// p h, p h, (1 − 4p) h, p h, p h with p = 1/(4 − 4^(1/3)); M. Suzuki, Phys. Lett. A 146, 319 (1990).
class FourthOrder : public VelocityVerlet {
 public:
  std::span<const double> substeps() const override;
};

// Position Verlet, with forces evaluated at mid-step:
//   x(t + h/2) = x(t) + h/2 v(t)                                       begin_step, predicting v(t) + h/2 F/m
//   v(t + h) = v(t) + h F(t + h/2)/m,  x(t + h) = x(t + h/2) + h/2 v(t + h)   finish_step
class PositionVerlet : public Integrator {
 public:
  bool evaluates_at_mid_step() const override { return true; }
  double begin_step(Particles& particles, double step, BodyRange bodies) override;
  bool finish_step(Particles& particles, double step, BodyRange bodies) override;
};

}  // namespace scree
