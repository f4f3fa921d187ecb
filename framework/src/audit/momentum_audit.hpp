#pragma once

#include "bodies/body_range.hpp"

#include <vector>

#include <scree/particles.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// Momentum that contacts make, which their pairs and planes must cancel, against the momentum that they
// exchange.
class MomentumAudit {
 public:
  // Forces of contacts in one evaluation (N): their sum, and that of the sizes of their components.
  struct Sums {
    Vec3 force = {};
    double size = 0;

    // Of bodies, before body forces add to them.
    void add(const Particles& particles, BodyRange bodies);
    void add(const Sums& other);
  };

  // Adds one evaluation, over a step (s).
  void add_step(double step, Sums bodies, const std::vector<scree_load>& loads);
  // Made over exchanged; 0 while nothing is exchanged.
  double residual() const;

 private:
  Vec3 made_ = {};        // (N s)
  double exchanged_ = 0;  // (N s)
};

}  // namespace scree
