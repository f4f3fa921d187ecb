#pragma once

#include "contacts/kernel/block_task.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

// What is read later is prefetched into the second-level cache, a few cache lines at a time: a processor can
// have some twenty on their way and waits when it is to fetch one more.

namespace scree::kernel {

constexpr int second_level_cache = 2;
constexpr std::size_t cache_line = 64;

// The bodies that the next tile reads: records and loads of its own, and records of other tiles.
template <int D, bool spin>
class BodiesAhead {
 public:
  // calls: number of calls of prefetch() during the evaluation of the tile.
  BodiesAhead(const TileJob& job, std::size_t calls) : records_(job.input->records), loads_(job.slots) {
    if (!job.tiles->exceed_caches() || job.tile + 1 == job.tiles->tiles().size()) return;
    const BodyRange own = job.tiles->bodies()[job.tile + 1];
    next_ = own.begin, end_ = own.end;
    foreign_ = job.tiles->tiles()[job.tile + 1].foreign;
    bodies_per_call_ = (end_ - next_ + foreign_.size()) / (calls + 1) + 1;
  }

  SCREE_HOT void prefetch() {
    for (std::size_t k = 0; k < bodies_per_call_; ++k) prefetch_one();
  }

 private:
  SCREE_HOT void prefetch_one() {
    if (next_ < end_) {
      __builtin_prefetch(loads_ + record::load_width(D, spin) * next_, 0, second_level_cache);
      prefetch_record(next_++);
    } else if (next_foreign_ < foreign_.size()) {
      prefetch_record(foreign_[next_foreign_++]);
    }
  }
  SCREE_HOT void prefetch_record(std::size_t body) const {
    constexpr std::size_t width = record::width(D, spin);
    for (std::size_t part = 0; part < width; part += cache_line / sizeof(double))
      __builtin_prefetch(records_ + width * body + part, 0, second_level_cache);
  }

  const double *records_, *loads_;
  std::size_t next_ = 0, end_ = 0, next_foreign_ = 0, bodies_per_call_ = 0;
  std::span<const std::uint32_t> foreign_;
};

// What some blocks later is read of pairs: places and slots of their bodies, constants, histories.
class PairsAhead {
 public:
  explicit PairsAhead(const BlockTask& task) {
    const Contacts& contacts = task.tile.input->contacts;
    const Tiles& tiles = *task.tile.tiles;
    const std::size_t first = task.pairs.begin + distance;
    indices_ = {contacts.a.data() + first, contacts.b.data() + first, tiles.slot_a().data() + first,
                tiles.slot_b().data() + first};
    numbers_[count_++] = task.radius_sum + distance;
    for (const PairColumns& term : task.tile.constants->terms)
      if (term.size() > 0) numbers_[count_++] = term.column(0) + first;
    for (std::uint32_t k = 0; k < std::min(task.group.history_width, most_histories); ++k)
      numbers_[count_++] = task.group.history.column(k) + (first - task.group.begin);
  }

  // i: pair of the block, a multiple of four.
  SCREE_HOT void prefetch(std::uint32_t i) const {
    if (i % (cache_line / sizeof(double)) == 0)
      for (std::uint32_t k = 0; k < count_; ++k) __builtin_prefetch(numbers_[k] + i, 0, second_level_cache);
    if (i % (cache_line / sizeof(std::uint32_t)) == 4)
      for (const std::uint32_t* index : indices_) __builtin_prefetch(index + i, 0, second_level_cache);
  }

 private:
  static constexpr std::size_t distance = 4 * block_size;
  static constexpr std::uint32_t most_histories = 6;

  std::array<const std::uint32_t*, 4> indices_;
  std::array<const double*, 1 + PairConstants::column_count + most_histories> numbers_;
  std::uint32_t count_ = 0;
};

}  // namespace scree::kernel
