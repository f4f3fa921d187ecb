#pragma once

#include "bodies/body_range.hpp"
#include "bodies/body_sums.hpp"
#include "plugins/clock.hpp"

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

  // Of an evaluation, and of the one before (s).
  struct Times {
    double now, before;
  };
  // Adds to the forces and torques of a range of bodies, and to the sums.
  void apply(Times times, Particles& particles, const Domain& domain, BodyRange bodies, BodySums& sums) const;
  // Adds to the loads and energies of a batch.
  void apply(Times times, scree_body_batch& batch) const;
  // Largest rate at which any body force damps any of the bodies (1/s); 0 without drag.
  double largest_damping_rate(const std::vector<Body>& bodies) const;
  // Its functions of time start again at `time` (s), but functions of the keys in `going_on`
  // continue.
  void reconfigure(const std::string& name, const Parameters& parameters, double time,
                   const std::vector<std::string>& going_on);
  // Begins functions of time anew, at t = 0.
  void begin_anew();
  void transfer(const class StateTransfer& state);

 private:
  struct Member {
    Scene::BodyForce entry;
    ConfiguredBodyForce plugin;
    Clock clock = {};
    bool absent() const { return entry.parameters.absent(); }
  };
  void configure(Member& member) const;
  int dimension_;
  bool audit_;
  std::vector<Member> members_;
};

}  // namespace scree
