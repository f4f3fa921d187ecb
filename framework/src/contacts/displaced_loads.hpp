#pragma once

#include "contacts/contacts.hpp"
#include "contacts/forces.hpp"
#include "contacts/kernel/plane_load.hpp"
#include "contacts/kernel/plane_records.hpp"
#include "contacts/pair_constants.hpp"

#include <cstdint>
#include <vector>

#include <scree/particles.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// Evaluates the contacts of single planes with displacements that the planes might have, without a trace in
// bodies, histories or sums. By one thread, in the order of the pairs of each tile; sums over tiles are
// exact, so that the bits are the same for any number of threads and ranks.
class DisplacedLoads {
 public:
  // share: of this rank if several compute the scene, or null.
  explicit DisplacedLoads(const Forces::Features& features, RankShare* share = nullptr);

  // What the contacts follow from: bodies at the end of a step (s) with predicted velocities, planes.
  struct Scene {
    const Particles& particles;
    const Contacts& contacts;
    const std::vector<LawInstance>& laws;
    const std::vector<scree_plane>& planes;
    const Domain& domain;
    double step;
    double kick;  // (s) for which the forces act
  };
  // Load of a plane (N) after a displacement (m) in the step, at constant velocity.
  scree_load load(const Scene& scene, std::size_t plane, const double* displacement);
  // Over ranks: waits until no rank asks for loads any more, and adds none to theirs. A rank whose boundary
  // fails asks for fewer than others.
  void finish(int dimension);

 private:
  // Of all tiles; `asking`: the number of ranks that ask now, of which this is one.
  struct Total {
    scree_load load = {};
    std::int64_t asking = 0;
  };
  Total total(const std::vector<scree_load>& of_tiles, int dimension, bool asking) const;
  // The pairs of one plane and, per group, their rows in the group of all pairs.
  struct PlanePairs {
    std::uint64_t revision = 0;  // of the contacts from which they were taken
    Contacts contacts;
    PairConstants constants;
    std::vector<std::vector<PairColumns::Move>> rows;
  };
  PlanePairs& pairs_of(const Scene& scene, std::size_t plane);
  void take(const Scene& scene, std::size_t plane, PlanePairs& pairs) const;

  kernel::EvaluatePlaneLoad evaluate_;
  RankShare* share_;
  std::vector<PlanePairs> pairs_;  // of each plane, filled when its load is first asked for
  std::vector<scree_plane> planes_;
  kernel::PlaneRecords records_;
};

}  // namespace scree
