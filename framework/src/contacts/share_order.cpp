#include "contacts/share_order.hpp"

#include <algorithm>
#include <utility>

namespace scree {

namespace {

std::size_t blocks_of(const kernel::Tiles& tiles, const std::vector<std::uint32_t>& list) {
  std::size_t blocks = 0;
  for (const std::uint32_t tile : list)
    blocks += tiles.tiles()[tile].last_block - tiles.tiles()[tile].first_block;
  return blocks;
}

// Moves tiles from the end of one list to the beginning of another, until that has enough blocks.
void move_back(const kernel::Tiles& tiles, std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& to,
               std::size_t enough) {
  std::size_t blocks = 0;
  auto first = from.end();
  while (first != from.begin() && blocks < enough) blocks += blocks_of(tiles, {*--first});
  to.insert(to.begin(), first, from.end());
  from.erase(first, from.end());
}

}  // namespace

ShareOrder::ShareOrder(const kernel::Tiles& tiles, const std::vector<std::uint32_t>& own, const Halo& halo)
    : last_first(own.rbegin(), own.rend()) {
  const std::size_t all = blocks_of(tiles, own), quarter = (all + 3) / 4;
  std::vector<std::uint32_t> independent, readers;
  for (const std::uint32_t tile : own) {
    if (halo.is_loaded_by_others(tile)) loaded.push_back(tile);
    (halo.reads_others(tile) ? readers : independent).push_back(tile);
  }
  const auto first_loaded =
      std::stable_partition(independent.begin(), independent.end(),
                            [&](std::uint32_t tile) { return !halo.is_loaded_by_others(tile); });
  const std::size_t left = blocks_of(tiles, independent);
  if (left > 2 * quarter) {
    std::vector<std::uint32_t> finished_late(first_loaded, independent.end());
    independent.erase(first_loaded, independent.end());
    move_back(tiles, finished_late, after_loads, std::min(all / 5, left - 2 * quarter));
    independent.insert(independent.end(), finished_late.begin(), finished_late.end());
  }
  move_back(tiles, independent, kept, quarter);
  before_records = std::move(independent);
  std::size_t before = blocks_of(tiles, before_records);
  for (const std::uint32_t tile : readers) {
    (before < quarter ? split : reading).push_back(tile);
    before += tiles.tiles()[tile].first_crossing - tiles.tiles()[tile].first_block;
  }
}

}  // namespace scree
