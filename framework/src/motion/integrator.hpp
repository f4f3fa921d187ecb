#pragma once

#include "bodies/body_range.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <scree/integration.hpp>
#include <scree/particles.hpp>
#include <scree/ranks.hpp>
#include <scree/state_hash.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

class RowRoutes;

// Moves bodies, in translation and rotation, before and after each force evaluation. Velocity-dependent
// forces use a prediction for the time of evaluation, made with the forces of the last evaluation; tangential
// springs advance with mid_velocity, the displacement since the last evaluation divided by the time since.
class Integrator {
 public:
  virtual ~Integrator() = default;

  // Substeps as fractions of a step, taken in this order, negative ones backwards in time; they add up to 1.
  virtual std::span<const double> substeps() const;
  // Whether forces are evaluated at mid-step instead of at the end of the step.
  virtual bool evaluates_at_mid_step() const { return false; }

  // Called once, for the bodies that this process moves, before the first half of a step (s).
  virtual void prepare(Particles&, double /*step*/, std::span<const BodyRange>) {}
  // First half of a step (s): moves positions to the time of force evaluation and predicts velocities there.
  // Returns the largest squared speed of the motion (m²/s²); infinite if any velocity is not finite.
  virtual double begin_step(Particles& particles, double step, BodyRange bodies) = 0;
  // Second half: completes the step with the new forces. Returns whether all velocities and spins are finite.
  virtual bool finish_step(Particles& particles, double step, BodyRange bodies) = 0;
  // finish_step of one step and begin_step of the next, possibly in one pass over the bodies.
  struct Moved {
    bool finite;
    double square_speed;  // (m²/s²)
  };
  virtual Moved finish_and_begin_step(Particles& particles, double step, double next, BodyRange bodies);

  // Called when forces have changed discontinuously, before the next step: derivatives of them start anew.
  virtual void restart() {}

  // What the integrator keeps besides positions and velocities, in scene order; nothing by default.
  virtual void add_to_hash(StateHash&, const BodyOrder&) const {}
  virtual void transfer(const StateTransfer&, const BodyOrder&) {}
  // Sends what it keeps of bodies to other ranks.
  virtual void send(Ranks&, const RowRoutes&, std::size_t /*bodies*/) {}
  // Moves the bodies in memory, see Particles::rearrange.
  virtual void rearrange(const std::vector<std::uint32_t>& /*from*/, std::span<const BodyRange> /*kept*/) {}
};

std::unique_ptr<Integrator> make_integrator(Integration integration);

}  // namespace scree
