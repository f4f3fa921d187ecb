#pragma once

#include "bodies/body_range.hpp"

#include <memory>
#include <span>

#include <scree/integration.hpp>
#include <scree/particles.hpp>

namespace scree {

// Moves bodies, in translation and rotation, around each evaluation of the forces.
// Forces that depend on velocity see a prediction for the moment of evaluation, made with the forces of the
// last one; tangential springs move by mid_velocity, the displacement since the last evaluation over its
// time.
class Integrator {
 public:
  virtual ~Integrator() = default;

  // Shares of a step that are made one after the other, negative ones back in time; they add up to 1.
  virtual std::span<const double> substeps() const;
  // Forces are evaluated in the middle of a step rather than at its end.
  virtual bool evaluates_at_mid_step() const { return false; }

  // Called once for all bodies before any of them begins a step (s).
  virtual void prepare(Particles&, double /*step*/) {}
  // Moves positions to where forces are to be evaluated, and predicts velocities there. Returns the largest
  // squared speed of the move (m²/s²); infinite if any velocity is not a number.
  virtual double begin_step(Particles& particles, double step, BodyRange bodies) = 0;
  // Completes the step with the forces there. Returns whether all velocities and spins are numbers.
  virtual bool finish_step(Particles& particles, double step, BodyRange bodies) = 0;
  // finish_step of one step and begin_step of the next, which may take one pass over the bodies.
  struct Moved {
    bool finite;
    double square_speed;  // (m²/s²)
  };
  virtual Moved finish_and_begin_step(Particles& particles, double step, double next, BodyRange bodies);
};

std::unique_ptr<Integrator> make_integrator(Integration integration);

}  // namespace scree
