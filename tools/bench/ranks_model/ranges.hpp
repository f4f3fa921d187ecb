#pragma once

// Ranges of tiles of equal work for the ranks of a scene, and the messages between these ranks in a step.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <vector>

namespace ranks_model {

constexpr std::size_t tile_size = 1024;  // bodies, BodyTiles::usual_size of the framework

// A pair of bodies costs this many times the motion of a body: 77 % and 23 % of a step with 3.14 pairs a body
// (PERFORMANCE.md, "Where the time of beads-4096 goes").
constexpr double pair_over_body = 0.77 / 0.23 / 3.14;

// Number of tiles of so many bodies; the last one has the rest.
inline std::size_t tile_count(std::size_t bodies) { return std::max<std::size_t>(1, bodies / tile_size); }

struct Tile {
  double bodies = 0;
  double inner = 0;  // pairs of bodies of the tile
  double cross = 0;  // pairs with bodies of tiles of higher place, which the tile evaluates

  double work() const { return bodies + pair_over_body * (inner + cross); }
};

// What a rank receives from another one of higher place.
struct Halo {
  double records = 0;  // bodies that its pairs read
  double loads = 0;    // pairs whose loads on these bodies it sends back
};

using Halos = std::vector<std::map<std::size_t, Halo>>;  // by receiving rank, then by sending rank

// The rank of each tile: contiguous ranges of equal work, as near as whole tiles allow.
inline std::vector<std::size_t> rank_of_tiles(const std::vector<Tile>& tiles, std::size_t ranks) {
  double all = 0, before = 0;
  for (const Tile& tile : tiles) all += tile.work();
  std::vector<std::size_t> rank;
  for (const Tile& tile : tiles) {
    rank.push_back(std::min(ranks - 1, std::size_t((before + tile.work() / 2) * double(ranks) / all)));
    before += tile.work();
  }
  return rank;
}

// A line for each rank: bodies, pairs inside tiles, pairs between tiles, then for each rank with which it
// exchanges messages its number, records and loads. Records go to the lower rank, loads to the higher one.
inline void print(const std::vector<Tile>& tiles, const std::vector<std::size_t>& rank, const Halos& halos) {
  std::vector<Tile> own(halos.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    own[rank[t]].bodies += tiles[t].bodies;
    own[rank[t]].inner += tiles[t].inner;
    own[rank[t]].cross += tiles[t].cross;
  }
  Halos both = halos;
  for (std::size_t low = 0; low < halos.size(); ++low)
    for (const auto& [high, halo] : halos[low]) both[high][low] = halo;
  for (std::size_t r = 0; r < halos.size(); ++r) {
    std::printf("%.0f %.0f %.0f", own[r].bodies, own[r].inner, own[r].cross);
    for (const auto& [other, halo] : both[r])
      std::printf(" %zu %.0f %.0f", other, std::max(1.0, halo.records), std::max(1.0, halo.loads));
    std::printf("\n");
  }
}

}  // namespace ranks_model
