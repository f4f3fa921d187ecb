#include "ranks/row_routes.hpp"

#include <scree/body_order.hpp>

namespace scree {

void RowRoutes::add(unsigned here, unsigned from, unsigned to, BodyRange range) {
  if (from == to || (from != here && to != here)) return;
  std::vector<BodyRange>& ranges = from == here ? sent_[to] : received_[from];
  if (!ranges.empty() && ranges.back().end == range.begin)
    ranges.back().end = range.end;
  else
    ranges.push_back(range);
}

RowRoutes RowRoutes::to_first(const RankShare& share, const BodyTiles& tiles) {
  return to_owners(share, tiles, TileOwners(tiles.count()));
}

RowRoutes RowRoutes::to_first(const RankShare& share, const BodyTiles& tiles,
                              const std::vector<std::uint32_t>& places) {
  RowRoutes routes(share.ranks.size());
  for (const std::uint32_t place : places)
    routes.add(share.ranks.rank(), share.owners.rank_of(tiles.owner(place)), 0, {place, place + 1u});
  return routes;
}

RowRoutes RowRoutes::to_owners(const RankShare& share, const BodyTiles& tiles, const TileOwners& next) {
  RowRoutes routes(share.ranks.size());
  for (std::size_t tile = 0; tile < tiles.count(); ++tile)
    routes.add(share.ranks.rank(), share.owners.rank_of(tile), next.rank_of(tile), tiles[tile]);
  return routes;
}

RowRoutes RowRoutes::to_places(const RankShare& share, const BodyTiles& tiles,
                               const std::vector<std::uint32_t>& from) {
  RowRoutes routes(share.ranks.size());
  const std::vector<std::uint32_t> to = inverse_of(from);
  for (std::size_t place = 0; place < to.size(); ++place)
    routes.add(share.ranks.rank(), share.owners.rank_of(tiles.owner(place)),
               share.owners.rank_of(tiles.owner(to[place])), {place, place + 1});
  return routes;
}

}  // namespace scree
