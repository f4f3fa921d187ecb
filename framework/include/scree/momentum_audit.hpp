#pragma once

#include <vector>

#include <scree/particles.hpp>
#include <scree/plugin_abi.h>

namespace scree {

// Momentum that contacts make, which their pairs and planes must cancel, against the momentum that they
// exchange.
class MomentumAudit {
 public:
  // Adds the forces of one evaluation, before body terms, over a step (s).
  void add_step(double step, const Particles& particles, const std::vector<scree_load>& loads);
  // Made over exchanged; 0 while nothing is exchanged.
  double residual() const;

 private:
  Vec3 made_ = {};        // (N s)
  double exchanged_ = 0;  // (N s)
};

}  // namespace scree
