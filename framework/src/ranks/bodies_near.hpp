#pragma once

#include "bodies/body_range.hpp"
#include "ranks/messages.hpp"
#include "ranks/rank_share.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include <scree/domain.hpp>
#include <scree/pair_search.hpp>

namespace scree {

// The bodies among which a rank finds the pairs of its tiles: its own, and bodies of later tiles of other
// ranks that may be near.
class NearBodies {
 public:
  // Lists the bodies that may be within the skin (m) of this rank's. bodies: by place, current for this
  // rank's.
  void find(RankShare& share, std::span<const Sphere> bodies, const Domain& domain, double skin);
  // Brings the listed bodies to where they are now. The tiles must belong to the same ranks, and the bodies
  // be at the same places.
  void update(RankShare& share, std::span<const Sphere> bodies);

  // Brings a property of the listed bodies of other ranks to their places.
  template <class Item>
  void bring(RankShare& share, Item* items) const {
    std::vector<std::vector<Item>> sent(sent_.size());
    for (std::size_t r = 0; r < sent_.size(); ++r)
      for (const std::uint32_t place : sent_[r]) sent[r].push_back(items[place]);
    const std::vector<std::vector<Item>> received = exchange_items(share.ranks, std::move(sent));
    for (std::size_t r = 0; r < received_.size(); ++r)
      for (std::size_t k = 0; k < received_[r].size(); ++k) items[places_[received_[r][k]]] = received[r][k];
  }

  const std::vector<Sphere>& spheres() const { return spheres_; }       // in the order of their places
  const std::vector<std::uint32_t>& places() const { return places_; }  // of each

 private:
  // received: places of bodies of each other rank.
  void list(const std::vector<std::vector<std::uint32_t>>& received, const TileOwners& owners,
            const BodyTiles& tiles);

  std::vector<Sphere> spheres_;
  std::vector<std::uint32_t> places_;
  std::vector<std::uint32_t> own_;  // indices of this rank's
  std::vector<std::vector<std::uint32_t>> sent_,
      received_;  // places sent to, indices received from each rank
};

}  // namespace scree
