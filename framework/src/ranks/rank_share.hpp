#pragma once

#include "ranks/tile_owners.hpp"

#include <scree/ranks.hpp>

namespace scree {

// The share of this process in a scene that several ranks compute.
struct RankShare {
  Ranks& ranks;
  TileOwners owners;
  std::uint64_t dealt_after = 0;  // searches
};

}  // namespace scree
