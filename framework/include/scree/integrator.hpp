#pragma once

#include <memory>
#include <span>
#include <string>

#include <scree/body_range.hpp>
#include <scree/particles.hpp>

namespace scree {

// How bodies move from one evaluation of the forces to the next.
enum class Integration { velocity_verlet, position_verlet, fourth_order, predictor_corrector };

// What to know before choosing.
struct IntegrationTraits {
  Integration integration;
  const char* name;     // as in a scenario
  const char* summary;  // one line: scheme, order, what damping and contact onset do to it
  int evaluations;      // of the forces in a step
  // The longest stable step as a share of velocity Verlet's, which for an oscillator with frequency ω and
  // damping rate η is 2/(√(4η² + ω²) + 2η).
  double stable_step;
};
std::span<const IntegrationTraits> integrations();
const IntegrationTraits& traits_of(Integration integration);

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

  // Called before the bodies drift, once for all.
  virtual void prepare(Particles&, double /*step*/) {}
  // Moves positions to where forces are to be evaluated, and predicts velocities there. Largest squared speed
  // on the way (m²/s²); infinite if any velocity is not a number.
  virtual double drift(Particles& particles, double step, BodyRange bodies) = 0;
  // Completes the step with the forces there. Returns whether all velocities and spins are numbers.
  virtual bool kick(Particles& particles, double step, BodyRange bodies) = 0;
  // A kick and the drift of the next step, which may take one pass over the bodies.
  struct Moved {
    bool finite;
    double square_speed;  // (m²/s²)
  };
  virtual Moved kick_and_drift(Particles& particles, double step, double next, BodyRange bodies);
};

std::unique_ptr<Integrator> make_integrator(Integration integration);

}  // namespace scree
