#include "contacts/kernel/tiles.hpp"

#include "bodies/counting_sort.hpp"
#include "contacts/kernel/block.hpp"

#include <algorithm>

namespace scree::kernel {

// First the blocks of pairs inside the tile: their evaluation needs no body of another tile.
void Tiles::cut_blocks(const Contacts& contacts, std::uint32_t t) {
  tiles_[t].first_block = blocks_.size();
  for (const bool crossing : {false, true})
    for (std::uint32_t g = 0; g < contacts.groups().size(); ++g) {
      const PairGroup& group = contacts.groups()[g];
      if (group.runs.empty()) continue;
      const PairRun& run = group.runs[t];
      for (std::size_t p = run.begin; p < run.end; p += block_size) {
        const std::size_t pairs = std::min<std::size_t>(block_size, run.end - p);
        if ((p + pairs > run.crossing) != crossing) continue;
        blocks_.push_back({g, p, std::uint32_t(padded_to_lanes(pairs)), std::uint32_t(pairs)});
      }
    }
  tiles_[t].last_block = blocks_.size();
}

void Tiles::assign_slots(const Contacts& contacts, std::size_t planes) {
  resize_with_room(slot_a_, contacts.padded_size());
  resize_with_room(slot_b_, contacts.padded_size());
  for (std::uint32_t t = 0; t < tiles_.size(); ++t) {
    Tile& tile = tiles_[t];
    const auto slot_of = [&](std::uint32_t body) {
      const auto owner = std::uint32_t(bodies_.owner(body));
      if (owner == t) return body;
      outgoing_.push_back({body, std::uint32_t(slots_)});
      tile.reached.push_back(owner);
      return std::uint32_t(slots_++);
    };
    tile.first_foreign = slots_;
    for (std::size_t k = tile.first_block; k < tile.last_block; ++k) {
      const PairBlock& block = blocks_[k];
      const PairGroup& group = contacts.groups()[block.group];
      for (std::size_t p = block.begin; p < block.begin + block.pairs; ++p) {
        slot_a_[p] = slot_of(contacts.a[p]);
        if (!group.planes) slot_b_[p] = slot_of(contacts.b[p]);
      }
    }
    tile.last_foreign = tile.first_own = slots_;
    slots_ += planes + 1;
    for (std::size_t k = tile.first_block; k < tile.last_block; ++k) {
      const PairBlock& block = blocks_[k];
      const PairGroup& group = contacts.groups()[block.group];
      for (std::size_t p = block.begin; p < block.begin + block.count; ++p) {
        const bool padding = p >= block.begin + block.pairs;
        if (padding) slot_a_[p] = slot_b_[p] = std::uint32_t(tile.first_own + planes);
        if (!padding && group.planes) slot_b_[p] = std::uint32_t(tile.first_own + contacts.b[p]);
      }
    }
  }
}

void Tiles::find_reached_tiles() {
  for (std::uint32_t t = 0; t < tiles_.size(); ++t) {
    Tile& tile = tiles_[t];
    std::vector<std::uint32_t>& reached = tile.reached;
    reached.push_back(t);
    std::sort(reached.begin(), reached.end());
    reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
    for (const std::uint32_t other : reached) ++tiles_[other].reached_by;
  }
}

// In the order in which they are read.
void Tiles::list_foreign_bodies(const Contacts& contacts) {
  if (!exceed_caches()) return;
  std::vector<std::uint32_t> listed_by(bodies_.size(), std::uint32_t(tiles_.size()));
  for (std::uint32_t t = 0; t < tiles_.size(); ++t)
    for (const PairGroup& group : contacts.groups()) {
      if (group.planes || group.runs.empty()) continue;
      for (std::size_t p = group.runs[t].crossing; p < group.runs[t].end; ++p)
        for (const std::uint32_t body : {contacts.a[p], contacts.b[p]}) {
          if (bodies_.owner(body) == t || listed_by[body] == t) continue;
          listed_by[body] = t;
          tiles_[t].foreign.push_back(body);
        }
    }
}

void Tiles::sort_incoming() {
  incoming_.resize(outgoing_.size());
  counting_sort(
      bodies_.parts(), first_incoming_,
      [&](const auto& visit) {
        for (const Incoming& in : outgoing_) visit(in);
      },
      [](const Incoming& in) { return in.body / BodyTiles::part_size; },
      [&](const Incoming& in, std::size_t index) { incoming_[index] = in; });
}

void Tiles::plan(const Contacts& contacts, std::size_t planes) {
  tiles_.assign(bodies_.count(), {});
  blocks_.clear(), outgoing_.clear();
  slots_ = bodies_.size();
  for (std::size_t t = 0; t < tiles_.size(); ++t) {
    cut_blocks(contacts, std::uint32_t(t));
  }
  assign_slots(contacts, planes);
  sort_incoming();
  find_reached_tiles();
  list_foreign_bodies(contacts);
}

}  // namespace scree::kernel
