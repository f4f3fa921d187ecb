#pragma once

#include "bodies/body_range.hpp"
#include "contacts/contacts.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include <scree/column.hpp>
#include <scree/thread_pool.hpp>

namespace scree::kernel {

// Division of the pairs of a scene into tiles that can be evaluated in parallel: a tile owns a range of
// bodies and evaluates its pairs (see Contacts), in blocks that belong to it alone. The loads of both ends of
// a pair are added to slots, assigned in advance:
//   [0, bodies)         slot of a body, used if the tile that evaluates the pair owns the body
//   behind              slot of one end of one pair, used if another tile owns the body
//   then, for each tile, a slot for each plane and one for padding
// Slots of the second kind are added to their bodies afterwards, in the order of the pairs. Tiles depend only
// on the scene, not on the number of threads, and so do the sums.
class Tiles {
 public:
  struct PairBlock {
    std::uint32_t group;
    std::size_t begin;    // pair
    std::uint32_t count;  // multiple of SCREE_LANES
    std::uint32_t pairs;  // without padding
  };
  struct Incoming {
    std::uint32_t body, slot;
  };
  // A load on a body that a tile of another rank computes.
  struct Arrival {
    std::uint32_t tile, body;
  };
  struct Tile {
    std::size_t first_block = 0, last_block = 0;      // [first, last)
    std::size_t first_crossing = 0;                   // block from which on pairs may be with other tiles
    std::size_t first_foreign = 0, last_foreign = 0;  // slots written for other tiles
    std::size_t first_own = 0, last_own = 0;          // slots of planes and padding: [first, last)
    std::size_t first_outgoing = 0;                   // of the slots for other tiles, counted over all tiles
    std::vector<std::uint32_t> foreign;  // bodies of other tiles that it reads, if exceed_caches()
    std::vector<std::uint32_t> reached;  // tiles whose bodies its pairs read and load, itself included
    std::uint32_t reached_by = 0;        // number of tiles that reach it, itself included
  };

  explicit Tiles(std::size_t bodies = 0) : bodies_(bodies) {}

  // Divides the pairs of some tiles into blocks and assigns slots; must be called after each neighbour
  // search.
  void plan(const Contacts& contacts, const std::vector<std::uint32_t>& planned, std::size_t planes,
            ThreadPool& threads);

  // Makes slots behind all others for loads of pairs of other ranks, which count in the order of their tiles.
  // Returns the first slot; they follow each other as given.
  std::size_t add_arrivals(const std::vector<Arrival>& arrivals);

  const BodyTiles& bodies() const { return bodies_; }

  const std::vector<Tile>& tiles() const { return tiles_; }
  const std::vector<PairBlock>& blocks() const { return blocks_; }
  std::size_t slots() const { return slots_; }
  // Whether the caches of a core and its share of a common one are too small, so that prefetching pays.
  bool exceed_caches() const { return tiles_.size() > tiles_in_cache; }
  // Slots of other tiles with loads for the bodies of a part, in the order of the pairs.
  std::span<const Incoming> incoming(std::size_t part) const {
    return {incoming_.data() + first_incoming_[part], incoming_.data() + first_incoming_[part + 1]};
  }
  // Slots of a tile with loads for bodies of other tiles.
  std::span<const Incoming> outgoing(std::size_t tile) const {
    const Tile& of = tiles_[tile];
    return {outgoing_.data() + of.first_outgoing, of.last_foreign - of.first_foreign};
  }
  // Slots of both ends of each pair, padding included.
  const Column<std::uint32_t>& slot_a() const { return slot_a_; }
  const Column<std::uint32_t>& slot_b() const { return slot_b_; }

 private:
  // 8 MB, at half a megabyte for a tile and its pairs. On an AMD EPYC with 2 MB a core and 32 MB for eight of
  // them, prefetching takes 4 % of the time with 8 tiles, 2 % with 16, and saves 4 % with 24, 35 % with 100.
  static constexpr std::size_t tiles_in_cache = 16;

  void cut_blocks(const Contacts& contacts, std::uint32_t tile);
  void count_slots(const Contacts& contacts, const std::vector<std::uint32_t>& planned, std::size_t planes);
  void assign_slots(const Contacts& contacts, std::size_t planes, std::uint32_t tile);
  void list_foreign_bodies(std::uint32_t tile);
  // loads: in the order in which they count.
  void sort_incoming(std::span<const Incoming> loads);

  BodyTiles bodies_;
  std::size_t slots_ = 0;
  std::vector<Tile> tiles_;
  std::vector<PairBlock> blocks_;
  std::vector<Incoming> outgoing_, incoming_;  // in the order of slots; of parts
  std::vector<std::uint32_t> first_incoming_;  // of each part
  Column<std::uint32_t> slot_a_, slot_b_;
};

}  // namespace scree::kernel
