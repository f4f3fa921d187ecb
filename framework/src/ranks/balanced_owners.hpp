#pragma once

#include "ranks/tile_owners.hpp"

#include <cstdint>
#include <vector>

#include <scree/ranks.hpp>
#include <scree/tile_graph.hpp>

// Tiles for each rank, with about as much work. No number depends on which way is taken.
namespace scree {

// Consecutive tiles, or what Ranks::partition has found if that is the better map; the same on all ranks.
// own: the edges of this rank's tiles, and their work; the work of other tiles is below 0.
TileOwners balanced_owners(Ranks& ranks, TileGraph own);

// The rank of each tile.
using TileMap = std::vector<std::uint32_t>;

// Consecutive tiles for each rank, whose work adds up to about the same sum.
TileMap ranges_of_tiles(const std::vector<double>& work, unsigned ranks);
// Pairs between tiles of different ranks, each of which takes messages, and the work of the busiest rank.
std::uint64_t pairs_across(const TileGraph& graph, const TileMap& map);
double largest_work(const TileGraph& graph, const TileMap& map, unsigned ranks);
// Whether a map has clearly fewer pairs across than another and hardly more work for the busiest rank, or far
// less.
bool is_better(const TileGraph& graph, const TileMap& map, const TileMap& than, unsigned ranks);
// The same map with ranks in the order of the mean numbers of their tiles.
TileMap in_order_of_tiles(const TileMap& map, unsigned ranks);

}  // namespace scree
