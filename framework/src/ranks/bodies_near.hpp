#pragma once

#include "bodies/body_range.hpp"
#include "ranks/rank_share.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include <scree/domain.hpp>
#include <scree/pair_search.hpp>

namespace scree {

// Bodies among which a rank finds the pairs of its tiles.
struct NearBodies {
  std::vector<Sphere> spheres;        // in the order of their places
  std::vector<std::uint32_t> places;  // of each
};

// The bodies of this rank, and those of later tiles of other ranks that may be within the skin (m) of them.
// bodies: by place, current for this rank's.
NearBodies find_near_bodies(RankShare& share, std::span<const Sphere> bodies, const Domain& domain,
                            double skin);

}  // namespace scree
