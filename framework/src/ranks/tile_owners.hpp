#pragma once

#include "bodies/body_range.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scree {

// The rank that computes each tile: its bodies, its pairs and their histories. No number depends on it.
class TileOwners {
 public:
  // All tiles belong to one process.
  explicit TileOwners(std::size_t tiles = 1);
  // rank_of: of each tile. by_graph: as a partitioner has divided the graph of tiles.
  TileOwners(std::vector<std::uint32_t> rank_of, unsigned rank, bool by_graph = false);
  // Tiles in no order, the same on all ranks for the same seed.
  static TileOwners at_random(std::size_t tiles, unsigned ranks, unsigned rank, std::uint64_t seed);

  bool is_own(std::size_t tile) const { return rank_of_[tile] == rank_; }
  std::uint32_t rank_of(std::size_t tile) const { return rank_of_[tile]; }
  unsigned rank() const { return rank_; }
  bool by_graph() const { return by_graph_; }
  // Tiles of this rank, in order.
  const std::vector<std::uint32_t>& own() const { return own_; }
  std::size_t tiles() const { return rank_of_.size(); }

 private:
  std::vector<std::uint32_t> rank_of_, own_;
  unsigned rank_ = 0;
  bool by_graph_ = false;
};

// Parts of the tiles of a rank, in order.
std::vector<std::uint32_t> own_parts(const BodyTiles& tiles, const TileOwners& owners);

}  // namespace scree
