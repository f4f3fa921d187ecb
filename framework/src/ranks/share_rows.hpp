#pragma once

#include "bodies/body_range.hpp"
#include "ranks/messages.hpp"
#include "ranks/rank_share.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace scree {

// Gives all ranks the rows of all bodies, `width` items a body by place, of which each rank has the rows of
// its tiles.
template <class Item>
void share_rows(const RankShare& share, const BodyTiles& tiles, Item* rows, std::size_t width) {
  std::vector<Item> own;
  for (const std::uint32_t tile : share.owners.own())
    own.insert(own.end(), rows + tiles[tile].begin * width, rows + tiles[tile].end * width);
  std::vector<std::vector<Item>> to_all(share.ranks.size(), own);
  to_all[share.ranks.rank()].clear();
  const std::vector<std::vector<Item>> received = exchange_items(share.ranks, to_all);
  std::vector<const Item*> next;
  for (const std::vector<Item>& of_rank : received) next.push_back(of_rank.data());
  for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
    if (share.owners.is_own(tile)) continue;
    const Item*& from = next[share.owners.rank_of(tile)];
    const std::size_t items = (tiles[tile].end - tiles[tile].begin) * width;
    std::copy_n(from, items, rows + tiles[tile].begin * width);
    from += items;
  }
}

}  // namespace scree
