#pragma once

#include "bodies/body_range.hpp"
#include "bodies/body_sums.hpp"

#include <string>
#include <vector>

#include <scree/domain.hpp>
#include <scree/particles.hpp>
#include <scree/plugin_host.hpp>
#include <scree/scene.hpp>

namespace scree {

// Body forces: forces on single bodies, such as gravity and background damping.
class BodyForces {
 public:
  // audit: whether energies are computed.
  BodyForces(const std::vector<Scene::BodyForce>& entries, int dimension, bool audit);

  // Adds to the forces and torques of a range of bodies, and to the sums.
  void apply(Particles& particles, const Domain& domain, BodyRange bodies, BodySums& sums) const;
  // Largest rate at which any body force damps any of the bodies (1/s); 0 without drag.
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
