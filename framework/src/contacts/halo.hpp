#pragma once

#include "contacts/kernel/tiles.hpp"
#include "ranks/rank_share.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include <scree/column.hpp>
#include <scree/particles.hpp>
#include <scree/ranks.hpp>

namespace scree {

// What pairs across ranks need: in each evaluation, records of bodies go to the ranks whose pairs read them,
// and the loads of these pairs come back.
class Halo {
 public:
  explicit Halo(const RankShare& share) : ranks_(share.ranks), owners_(share.owners) {}

  // Agrees with the other ranks on the messages of the planned pairs, and plans room for the loads that
  // come. orientations: pairs read them.
  void plan(kernel::Tiles& tiles, Particles& particles, bool orientations);

  // Records of bodies on other ranks; `finish_records` puts them to the places of these bodies.
  void begin_records(const Particles& particles);
  void finish_records(Particles& particles);
  // Loads that pairs of other ranks exert on bodies of this one; `finish_loads` has them in their slots.
  void begin_loads(const Particles& particles);
  void finish_loads(Particles& particles);

  // Adds what this rank has counted of bodies of other ranks, by place, to the counts of these ranks.
  void return_counts(BodyColumn<std::uint32_t>& counts);

  // Of a tile of this rank: whether its pairs read bodies of other ranks, and whether loads come for it.
  bool reads_others(std::size_t tile) const { return reads_others_[tile]; }
  bool is_loaded_by_others(std::size_t tile) const { return loaded_by_others_[tile]; }
  // Bodies of other ranks that the pairs of this one read, and bytes that it sends in an evaluation.
  std::size_t foreign_bodies() const;
  std::size_t bytes_sent() const { return sizeof(double) * (records_sent_.size() + loads_sent_.size()); }

 private:
  // Rows of each rank: [first[r], first[r + 1]).
  struct Rows {
    std::vector<std::uint32_t> rows;
    std::vector<std::size_t> first;
  };
  std::vector<std::vector<kernel::Tiles::Arrival>> find_departures(const kernel::Tiles& tiles);
  void agree_on_records(const std::vector<std::vector<kernel::Tiles::Arrival>>& departures);
  void agree_on_loads(const std::vector<std::vector<kernel::Tiles::Arrival>>& departures,
                      kernel::Tiles& tiles);
  // What pairs need of bodies of other ranks and no step changes.
  void bring_constants(Particles& particles);
  // Makes the state of bodies of other ranks that no message brings NaN.
  void poison(Particles& particles) const;
  // Numbers of a body in a message.
  std::size_t record_width(const Particles& particles) const;

  Ranks& ranks_;
  const TileOwners& owners_;
  bool orientations_ = false;
  Rows places_sent_, places_received_;  // of bodies
  Rows slots_sent_;
  std::vector<std::size_t> first_arrival_;  // of each rank, counted from first_arrival_slot_
  std::size_t first_arrival_slot_ = 0;
  std::vector<char> reads_others_, loaded_by_others_;  // of each tile
  std::vector<double> records_sent_, records_received_, loads_sent_, loads_received_;
};

}  // namespace scree
