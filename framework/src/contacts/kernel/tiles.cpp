#include "contacts/kernel/tiles.hpp"

#include "bodies/counting_sort.hpp"
#include "contacts/kernel/block.hpp"

#include <algorithm>

namespace scree::kernel {

namespace {

// Each number once, in order.
void sort_and_unite(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

// First the blocks of pairs inside the tile: their evaluation needs no body of another tile.
void Tiles::cut_blocks(const Contacts& contacts, std::uint32_t t) {
  tiles_[t].first_block = blocks_.size();
  for (const bool crossing : {false, true}) {
    tiles_[t].first_crossing = blocks_.size();
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
  }
  tiles_[t].last_block = blocks_.size();
}

// Exactly one body of a pair across tiles is of another tile.
void Tiles::count_slots(const Contacts& contacts, const std::vector<std::uint32_t>& planned,
                        std::size_t planes) {
  slots_ = bodies_.size();
  std::size_t foreign = 0;
  for (const std::uint32_t t : planned) {
    Tile& tile = tiles_[t];
    tile.first_foreign = slots_;
    tile.first_outgoing = foreign;
    for (const PairGroup& group : contacts.groups())
      if (!group.planes && !group.runs.empty()) slots_ += group.runs[t].end - group.runs[t].crossing;
    foreign += slots_ - tile.first_foreign;
    tile.last_foreign = tile.first_own = slots_;
    slots_ += planes + 1;
    tile.last_own = slots_;
  }
  outgoing_.resize(foreign);
  resize_with_room(slot_a_, contacts.padded_size());
  resize_with_room(slot_b_, contacts.padded_size());
}

void Tiles::assign_slots(const Contacts& contacts, std::size_t planes, std::uint32_t t) {
  Tile& tile = tiles_[t];
  std::size_t slot = tile.first_foreign;
  const auto slot_of = [&](std::uint32_t body) {
    const auto owner = std::uint32_t(bodies_.owner(body));
    if (owner == t) return body;
    outgoing_[tile.first_outgoing + (slot - tile.first_foreign)] = {body, std::uint32_t(slot)};
    tile.reached.push_back(owner);
    return std::uint32_t(slot++);
  };
  for (std::size_t k = tile.first_block; k < tile.last_block; ++k) {
    const PairBlock& block = blocks_[k];
    const bool planes_of_block = contacts.groups()[block.group].planes;
    const std::size_t end = block.begin + block.pairs;
    for (std::size_t p = block.begin; p < end; ++p) {
      slot_a_[p] = slot_of(contacts.a[p]);
      slot_b_[p] = planes_of_block ? std::uint32_t(tile.first_own + contacts.b[p]) : slot_of(contacts.b[p]);
    }
    for (std::size_t p = end; p < block.begin + block.count; ++p)
      slot_a_[p] = slot_b_[p] = std::uint32_t(tile.first_own + planes);
  }
  tile.reached.push_back(t);
  sort_and_unite(tile.reached);
}

void Tiles::list_foreign_bodies(std::uint32_t t) {
  Tile& tile = tiles_[t];
  for (std::size_t k = 0; k < tile.last_foreign - tile.first_foreign; ++k)
    tile.foreign.push_back(outgoing_[tile.first_outgoing + k].body);
  sort_and_unite(tile.foreign);
}

void Tiles::sort_incoming(std::span<const Incoming> loads) {
  incoming_.resize(loads.size());
  counting_sort(
      bodies_.parts(), first_incoming_,
      [&](const auto& visit) {
        for (const Incoming& in : loads) visit(in);
      },
      [](const Incoming& in) { return in.body / BodyTiles::part_size; },
      [&](const Incoming& in, std::size_t index) { incoming_[index] = in; });
}

void Tiles::plan(const Contacts& contacts, const std::vector<std::uint32_t>& planned, std::size_t planes,
                 ThreadPool& threads) {
  tiles_.assign(bodies_.count(), {});
  blocks_.clear();
  for (const std::uint32_t t : planned) cut_blocks(contacts, t);
  count_slots(contacts, planned, planes);
  threads.each(planned.size(), [&](std::size_t k, unsigned) {
    assign_slots(contacts, planes, planned[k]);
    if (exceed_caches()) list_foreign_bodies(planned[k]);
  });
  for (const Tile& tile : tiles_)
    for (const std::uint32_t other : tile.reached) ++tiles_[other].reached_by;
  sort_incoming(outgoing_);
}

std::size_t Tiles::add_arrivals(const std::vector<Arrival>& arrivals) {
  struct Load {
    std::uint32_t tile;
    Incoming incoming;
  };
  std::vector<Load> loads;
  for (std::uint32_t t = 0; t < tiles_.size(); ++t)
    for (const Incoming& out : outgoing(t)) loads.push_back({t, out});
  const std::size_t first = slots_;
  for (const Arrival& arrival : arrivals)
    loads.push_back({arrival.tile, {arrival.body, std::uint32_t(slots_++)}});
  std::stable_sort(loads.begin(), loads.end(),
                   [](const Load& one, const Load& other) { return one.tile < other.tile; });
  std::vector<Incoming> in_order;
  for (const Load& load : loads) in_order.push_back(load.incoming);
  sort_incoming(in_order);
  return first;
}

}  // namespace scree::kernel
