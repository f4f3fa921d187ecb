#pragma once

#include <memory>
#include <string>
#include <vector>

#include <scree/profile.hpp>
#include <scree/ranks.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/stage.hpp>

namespace scree::tool {

// How to time a scene.
struct BenchOptions {
  unsigned threads = 1, repeats = 5;
  double start = 0;         // (s) in the scene, from when on steps are timed
  std::uint64_t steps = 0;  // of a repeat; 0: as many as take `seconds`
  double seconds = 0.5;
  Ranks* ranks = nullptr;  // that compute the scene together; or null
};

// What one benchmark came to.
struct BenchResult {
  std::size_t particles, contacts, bytes_per_particle, bytes_per_contact;  // at the end
  std::size_t listed_pairs;                                                // the same, see Footprint
  double crossing_share;
  std::size_t foreign_bodies, bytes_sent;
  bool by_graph;
  std::uint64_t steps;             // of a repeat
  double first_time;               // (s) in the scene
  std::vector<double> s_per_step;  // of each repeat
  Profile profile;                 // of one more repeat
  std::uint64_t searches;          // for neighbours, in that
  std::uint64_t state_hash;        // at the end

  double median() const;
};

// Times steps of a scenario, stages included, without probes and pictures. Repeats go on from each other; a
// scene that ends is begun anew. Throws Error if it ends before options.start.
BenchResult time_steps(const scenario::Plan& plan, const BenchOptions& options);

}  // namespace scree::tool
