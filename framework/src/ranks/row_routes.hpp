#pragma once

#include "bodies/body_range.hpp"
#include "ranks/messages.hpp"
#include "ranks/rank_share.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace scree {

// Which rows of bodies, by place, each rank sends to each other rank. A rank has the rows of its tiles.
class RowRoutes {
 public:
  // All rows to the first rank.
  static RowRoutes to_first(const RankShare& share, const BodyTiles& tiles);
  // The rows of some places, in increasing order, to the first rank.
  static RowRoutes to_first(const RankShare& share, const BodyTiles& tiles,
                            const std::vector<std::uint32_t>& places);
  // The rows of tiles to their next owners.
  static RowRoutes to_owners(const RankShare& share, const BodyTiles& tiles, const TileOwners& next);
  // Rows to the owners of the places that they are about to have; each place takes the row at `from[place]`.
  static RowRoutes to_places(const RankShare& share, const BodyTiles& tiles,
                             const std::vector<std::uint32_t>& from);

  // Sends rows of `width` items, and puts rows that come to their places.
  template <class Item>
  void send(Ranks& ranks, Item* rows, std::size_t width) const {
    std::vector<std::vector<Item>> outgoing(sent_.size());
    for (std::size_t r = 0; r < sent_.size(); ++r)
      for (const BodyRange& range : sent_[r])
        outgoing[r].insert(outgoing[r].end(), rows + range.begin * width, rows + range.end * width);
    const std::vector<std::vector<Item>> incoming = exchange_items(ranks, std::move(outgoing));
    for (std::size_t r = 0; r < received_.size(); ++r) {
      const Item* next = incoming[r].data();
      for (const BodyRange& range : received_[r]) {
        const std::size_t items = (range.end - range.begin) * width;
        std::copy_n(next, items, rows + range.begin * width);
        next += items;
      }
    }
  }

 private:
  explicit RowRoutes(unsigned ranks) : sent_(ranks), received_(ranks) {}
  // Adds a range of places, in increasing order, that goes from one rank to another.
  void add(unsigned here, unsigned from, unsigned to, BodyRange range);

  std::vector<std::vector<BodyRange>> sent_, received_;  // of each rank
};

}  // namespace scree
