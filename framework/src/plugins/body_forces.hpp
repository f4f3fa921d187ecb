#pragma once

#include "audit/energy_audit.hpp"
#include "bodies/body_range.hpp"

#include <string>
#include <vector>

#include <scree/domain.hpp>
#include <scree/particles.hpp>
#include <scree/plugin_host.hpp>
#include <scree/scene.hpp>

namespace scree {

// Forces that act on each body by itself, such as gravity and background damping.
class BodyForces {
 public:
  // audit: whether energies are asked for.
  BodyForces(const std::vector<Scene::BodyForce>& entries, int dimension, bool audit);

  // Adds to the bodies' forces and torques, and to the sums.
  void apply(Particles& particles, const Domain& domain, BodyRange bodies, BodySums& sums) const;
  // Fastest at which any term slows any of the bodies (1/s); 0 without drag.
  double largest_damping_rate(const std::vector<Body>& bodies) const;
  void reconfigure(const std::string& name, const Parameters& parameters);

 private:
  struct Member {
    std::string name;
    ConfiguredBodyForce plugin;
  };
  int dimension_;
  bool audit_;
  std::vector<Member> members_;
};

}  // namespace scree
