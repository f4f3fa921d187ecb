#pragma once

#include <string>
#include <vector>

#include <scree/body_range.hpp>
#include <scree/domain.hpp>
#include <scree/energy_audit.hpp>
#include <scree/particles.hpp>
#include <scree/plugin_host.hpp>

namespace scree {

// Forces that act on each body by itself, such as gravity and background damping.
class BodyTerms {
 public:
  struct Entry {
    std::string name;
    Parameters parameters;
  };

  // audit: whether energies are asked for.
  BodyTerms(const std::vector<Entry>& entries, int dimension, bool audit);

  // Adds to the bodies' forces and torques, and to the sums.
  void apply(Particles& particles, const Domain& domain, BodyRange bodies, BodySums& sums) const;
  // Fastest at which any term slows any of the bodies (1/s); 0 without drag.
  double largest_damping_rate(const std::vector<Body>& bodies) const;
  void reconfigure(const std::string& name, const Parameters& parameters);

 private:
  struct Member {
    std::string name;
    ConfiguredBodyTerm plugin;
  };
  int dimension_;
  bool audit_;
  std::vector<Member> members_;
};

}  // namespace scree
