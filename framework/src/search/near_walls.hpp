#pragma once

#include "bodies/body_range.hpp"
#include "contacts/contacts.hpp"
#include "walls/boundaries.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <scree/pair_search.hpp>
#include <scree/thread_pool.hpp>

namespace scree {

class PlacedSurface;

// Finds the walls near bodies at each neighbour search. Bodies that were far from a surface are not asked
// again until they may have come near.
class NearWalls {
 public:
  // Walls nearer than the skin (m) to the bodies of some tiles, sorted by bodies, walls and spots. approach:
  // (m) by which bodies and surfaces may have come nearer since the last call; infinite: anything may have
  // happened.
  std::vector<PlanePair> find(std::span<const Sphere> bodies, const std::vector<std::uint32_t>& tiles,
                              const Boundaries& boundaries, double skin, double approach,
                              ThreadPool& threads);
  // After bodies have been moved in memory, or tiles dealt anew.
  void forget() { clearances_.clear(); }

 private:
  void shorten_clearances(double approach, std::size_t bodies, const std::vector<PlacedSurface>& surfaces,
                          const Domain& domain);

  std::vector<double> clearances_;  // (bodies, surfaces) (m) lower bounds of their distance at the last call
};

}  // namespace scree
