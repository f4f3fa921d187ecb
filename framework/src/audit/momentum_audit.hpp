#pragma once

#include "bodies/body_range.hpp"

#include <vector>

#include <scree/particles.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// Net momentum created by contact forces (0 in exact arithmetic) relative to the momentum exchanged.
class MomentumAudit {
 public:
  // Contact forces of one evaluation (N): their sum, and the sum of the magnitudes of their components.
  struct Sums {
    Vec3 force = {};
    double magnitude = 0;

    // Adds the loads of bodies; must be called before body forces are added to them.
    void add(const Particles& particles, BodyRange bodies);
    void add(const Sums& other) {
      force += other.force;
      magnitude += other.magnitude;
    }
  };

  // Adds one evaluation, weighted with the step (s), with the loads of planes and surfaces.
  void add_step(double step, Sums bodies, const std::vector<scree_load>& planes,
                const std::vector<scree_frame_load>& surfaces);
  // |net momentum| / exchanged momentum; 0 while none has been exchanged.
  double residual() const;
  void transfer(const class StateTransfer& state);

 private:
  Vec3 net_ = {};         // (N s)
  double exchanged_ = 0;  // (N s)
};

}  // namespace scree
