#pragma once

#include "ranks/rank_failure.hpp"
#include "ranks/tile_owners.hpp"

#include <cstdint>
#include <functional>

#include <scree/ranks.hpp>

namespace scree {

// The share of this process in a scene that several ranks compute.
struct RankShare {
  bool is_first() const { return ranks.rank() == 0; }

  Ranks& ranks;
  TileOwners owners;
  std::uint64_t dealt_after = 0;  // searches
  double busy = 0;                // (s) for which this rank has evaluated its tiles since they were dealt
  RankFailure failure = {};
  std::function<bool()> is_interrupted = {};  // whether this process has been asked to stop; may be empty
  bool other_is_interrupted = false;          // whether any rank has been asked, as of the last evaluation
};

}  // namespace scree
