#include "ranks/tile_owners.hpp"

#include <random>
#include <utility>

namespace scree {

TileOwners::TileOwners(std::size_t tiles) : TileOwners(std::vector<std::uint32_t>(tiles, 0), 0) {}

TileOwners::TileOwners(std::vector<std::uint32_t> rank_of, unsigned rank, bool by_graph)
    : rank_of_(std::move(rank_of)), rank_(rank), by_graph_(by_graph) {
  for (std::uint32_t tile = 0; tile < rank_of_.size(); ++tile)
    if (is_own(tile)) own_.push_back(tile);
}

TileOwners TileOwners::at_random(std::size_t tiles, unsigned ranks, unsigned rank, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<std::uint32_t> rank_of(tiles);
  for (std::uint32_t& owner : rank_of) owner = std::uint32_t(generator() % ranks);
  return {std::move(rank_of), rank};
}

std::vector<std::uint32_t> own_parts(const BodyTiles& tiles, const TileOwners& owners) {
  std::vector<std::uint32_t> parts;
  for (const std::uint32_t tile : owners.own())
    tiles.each_part(tile, [&](std::size_t part) { parts.push_back(std::uint32_t(part)); });
  return parts;
}

}  // namespace scree
