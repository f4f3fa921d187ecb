#pragma once

#include <limits>
#include <vector>

#include <scree/body_bounds.hpp>
#include <scree/particles.hpp>

namespace scree {

// What storage, walls and limits of a scene follow from of its bodies at the start.
struct BodyFacts {
  std::size_t count = 0;
  double mean_radius = 0, largest_radius = 0;  // (m); 0 without bodies
  double smallest_radius = std::numeric_limits<double>::infinity();
  BodyBounds bounds;
  Vec3 drift = {};  // (m/s) of the centre of mass; 0 if a body is fixed or held in part
  bool any_spins = false, any_fixed = false, any_held = false;

  void transfer(const class StateTransfer& state);
};
Vec3 drift_of(const std::vector<Body>& bodies);
BodyFacts facts_of(const std::vector<Body>& bodies, int dimension);

}  // namespace scree
