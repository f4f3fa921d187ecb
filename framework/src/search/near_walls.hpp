#pragma once

#include "bodies/body_range.hpp"
#include "contacts/contacts.hpp"
#include "walls/boundaries.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <scree/pair_search.hpp>
#include <scree/plugin/vec.hpp>
#include <scree/thread_pool.hpp>

namespace scree {

class PlacedSurface;

// Finds the walls near bodies at each neighbour search. Bodies that were far from a surface are not asked
// again before they have moved as far in its frame.
class NearWalls {
 public:
  // Walls nearer than the skin (m) to the bodies of some tiles, sorted by bodies, walls and spots.
  // approach: (m) by which any body and any surface may have come nearer since the last call; infinite: not
  // known.
  std::vector<PlanePair> find(std::span<const Sphere> bodies, const std::vector<std::uint32_t>& tiles,
                              const Boundaries& boundaries, double skin, double approach,
                              ThreadPool& threads);
  // After bodies have been moved in memory, tiles dealt anew or surfaces replaced.
  void forget() { clearances_.clear(); }

  // A lower bound (m) of the distance between a body and a surface when its centre was at a place (m) in the
  // frame of the surface, and the sum of all approaches until then.
  struct Clearance {
    Vec3 centre;
    double distance, approached;
    // Of meshes: while the centre moves by less than `smooth_travel` (m), the triangles within `smooth_skin`
    // (m) of where the body was allow one spot.
    double smooth_skin, smooth_travel;
  };

 private:
  std::vector<Clearance> clearances_;  // (bodies, surfaces)
  double approached_ = 0;              // (m) sum of all approaches
};

}  // namespace scree
