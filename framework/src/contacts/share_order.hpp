#pragma once

#include "contacts/halo.hpp"
#include "contacts/kernel/tiles.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scree {

// The tiles of one of several ranks in the order of their evaluation, on which no number depends. A quarter
// of the blocks of pairs, if possible, is evaluated while records come, and as many while loads come; of what
// is left at most a fifth follows, since loads come late. No more tiles are split than it takes: they are
// loaded into the cache twice.
struct ShareOrder {
  ShareOrder() = default;
  ShareOrder(const kernel::Tiles& tiles, const std::vector<std::uint32_t>& own, const Halo& halo);

  std::vector<std::uint32_t> before_records;  // read no bodies of other ranks
  std::vector<std::uint32_t> split;           // read some: the pairs inside are evaluated at once
  std::vector<std::uint32_t> reading;         // the same, but wait for the records
  std::vector<std::uint32_t> kept;            // read none; until the loads for other ranks are complete
  std::vector<std::uint32_t> after_loads;     // are finished while they are in the cache
  std::vector<std::uint32_t> loaded;          // all for which loads come
  std::vector<std::uint32_t> last_first;      // all, backwards
};

}  // namespace scree
