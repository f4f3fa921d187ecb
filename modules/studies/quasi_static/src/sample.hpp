#pragma once

#include <cstddef>
#include <vector>

#include <scree/response/quasi_static.hpp>
#include <scree/simulation.hpp>

namespace scree::quasi_static {

// A packing at one time, seen from its walls.
struct Sample {
  double time = 0;  // (s)
  std::vector<scree_plane> planes;
  std::vector<scree_load> loads;
  std::size_t contacts = 0, sliding = 0;
  bool dynamic = false;  // reached by dynamics
};

Sample sample_of(const response::QuasiStatic& packing, double time);
// Of dynamics.
Sample sample_of(const Simulation& moving, double time);

}  // namespace scree::quasi_static
