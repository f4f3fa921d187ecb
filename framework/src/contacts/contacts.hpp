#pragma once

#include "bodies/body_range.hpp"
#include "contacts/pair_columns.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <scree/body_order.hpp>
#include <scree/column.hpp>
#include <scree/domain.hpp>
#include <scree/pair_search.hpp>
#include <scree/plugin/abi.h>
#include <scree/thread_pool.hpp>
#include <scree/tile_graph.hpp>

namespace scree {

// Candidate pair of a body and a wall; walls are numbered, the planes first, then the surfaces. A body may
// meet a surface in several spots, which are numbered from 0.
struct PlanePair {
  std::uint32_t body, plane, spot = 0;
};

// Pairs with walls have no image; their byte says in which spot they touch.
constexpr std::uint8_t image_of_spot(std::uint32_t spot) { return std::uint8_t(Domain::no_shift + spot); }
constexpr std::uint32_t spot_of_image(std::uint8_t image) { return std::uint32_t(image - Domain::no_shift); }

constexpr std::size_t padded_to_lanes(std::size_t pairs) {
  return (pairs + SCREE_LANES - 1) / SCREE_LANES * SCREE_LANES;
}

// Pairs [begin, end) of one tile, filled up to a multiple of SCREE_LANES with padding; from `crossing` on
// they are with bodies of later tiles.
struct PairRun {
  std::size_t begin = 0, crossing = 0, end = 0;

  std::size_t padded_size() const { return padded_to_lanes(end - begin); }
};

// Candidate pairs with the same law and the same kind of partner: a contiguous range of the pair arrays.
struct PairGroup {
  std::uint32_t law = 0;
  bool planes = false;             // b is a wall: a plane or a surface
  bool surfaces = false;           // b is a surface
  std::size_t begin = 0;           // multiple of SCREE_LANES
  std::size_t end = 0;             // behind the last pair; padded to the next multiple of SCREE_LANES
  std::size_t pairs = 0;           // without padding
  std::vector<PairRun> runs = {};  // of each tile
  std::uint32_t history_width = 0;
  PairColumns history;  // (width, padded size), zero where the pair does not touch
  std::uint32_t spot_width = 0;
  PairColumns spots;  // the same: where spots of a mesh were in its frame (m), see SurfaceContacts

  std::size_t padded_size() const { return padded_to_lanes(end - begin); }
  // Calls visit(pair) for all pairs without padding.
  template <class Visit>
  void each_pair(const Visit& visit) const {
    for (const PairRun& run : runs)
      for (std::size_t q = run.begin; q < run.end; ++q) visit(q);
  }
  bool keeps_numbers() const { return history_width + spot_width > 0; }
  // Makes room for the numbers of all pairs; values are undefined afterwards.
  void resize_columns() {
    history.resize(history_width, padded_size());
    spots.resize(spot_width, padded_size());
  }
  // History value k of a pair, which is numbered over all groups.
  double history_of(std::size_t pair, std::uint32_t k) const { return history.column(k)[pair - begin]; }
};

// Pairs of bodies, and those of them whose bodies are in different tiles.
struct CrossingPairs {
  std::int64_t all = 0, crossing = 0;

  double share() const { return all > 0 ? double(crossing) / double(all) : 0; }
};

// All candidate pairs of a scene in a fixed order, with the histories of their laws. The pairs change only in
// a neighbour search; a pair touches while its overlap is positive. Bodies are listed by their places in
// memory; of two bodies, a has the lower number, so that histories keep their sense when bodies are moved in
// memory. A pair belongs to the tile of its body with the lower place.
class Contacts {
 public:
  // A combination of law and kind of partner that gets a group; groups are empty until `rebuild`.
  struct Kind {
    std::uint32_t law;
    bool planes;
    std::uint32_t history_width;
    bool surfaces = false;
    std::uint32_t spot_width = 0;
  };
  // Tables for finding the law of a pair: law_of[material_a * materials + material_b].
  struct Lookup {
    const std::uint32_t* law_of = nullptr;
    std::uint32_t materials = 0;
    const std::uint32_t* body_material = nullptr;
    const std::uint32_t* plane_material = nullptr;
    std::uint32_t surfaces_from = ~std::uint32_t(0);  // walls with this number and above are surfaces
  };

  // tiles: into which the pairs are divided.
  explicit Contacts(const std::vector<Kind>& kinds = {}, BodyTiles tiles = BodyTiles(0));

  // Replaces the pairs (of places, sorted by a, b) and keeps the histories of pairs that existed before.
  void rebuild(const std::vector<NeighbourPair>& bodies, const std::vector<PlanePair>& planes,
               const Lookup& lookup, const BodyOrder& order, ThreadPool& threads);

  // After bodies have been moved in memory: each place has taken the body at the place `from[place]`.
  void rearrange(const std::vector<std::uint32_t>& from);

  // Gives each rank the pairs and histories of its tiles, and further columns of the pairs, `width` of them.
  void send_to_owners(class Ranks& ranks, const class TileOwners& owners, PairColumns& further,
                      std::uint32_t width);

  // Number of pairs without padding.
  std::size_t listed() const;
  // Pairs of bodies, and those whose bodies are in different tiles: now, or if the bodies were rearranged.
  CrossingPairs crossing() const;
  CrossingPairs crossing(const std::vector<std::uint32_t>& from) const;
  // The same pairs between tiles, each number of them for its two tiles.
  std::vector<TileGraph::Edge> edges_of_tiles() const;

  // The pairs of a group in the order of their numbers, a first.
  std::vector<std::size_t> in_scene_order(const PairGroup& group, const BodyOrder& order) const;

  // Adds what laws keep of pairs, in scene order. share: ranks that have the pairs together, of which the
  // first gets the hash; null if these are all pairs.
  void add_to_hash(class StateHash& hash, const BodyOrder& order, struct RankShare* share) const;

  // Sets all histories to 0, as of pairs that do not touch.
  void clear_histories();

  // Fills a group of pairs with planes, which must be the next empty one, with history 0. For pairs that are
  // not replaced by `rebuild`.
  void append(std::size_t group, const std::vector<PlanePair>& pairs);

  // Pairs and histories in scene order, with as many planes as the scene has.
  void transfer(const class StateTransfer& state, const BodyOrder& order, std::size_t planes);

  // The group of a pair, given by the numbers of its bodies, and its row there; no group if it is not listed.
  struct Place {
    PairGroup* group;
    std::size_t row;
  };
  // spot: of a body and a wall.
  Place find(bool plane, std::uint32_t first, std::uint32_t second, const BodyOrder& order = {},
             std::uint32_t spot = 0);

  std::vector<PairGroup>& groups() { return groups_; }
  const std::vector<PairGroup>& groups() const { return groups_; }
  std::size_t padded_size() const { return a.size(); }

  Column<std::uint32_t> a, b;  // padding: the last a of its run with itself, or with the first plane
  Column<std::uint8_t> image;  // of b; of a wall its spot, see image_of_spot()

  // Number of rebuilds; data derived from the pairs is recomputed when it changes.
  std::uint64_t revision() const { return revision_; }

 private:
  // A pair by its places, and where its history comes from.
  struct Listed {
    std::uint32_t a, b;
    std::uint8_t image;
    std::uint32_t row;
  };
  // By which the pairs of a run are sorted: of two bodies, the lower place first; of a body and a wall, by
  // its spots.
  static std::uint64_t place_key(bool planes, std::uint32_t a, std::uint32_t b, std::uint8_t image);
  // Fills a group, which must be the next empty one, with pairs of a range that is sorted by place keys, and
  // history 0. choice.belongs(pair): to the group; choice.first(pair), choice.second(pair): its places, of
  // which the first is lower; choice.write(pair, index) sets a, b and image.
  template <class Pairs, class Choice>
  void fill(PairGroup& group, const Pairs& pairs, const Choice& choice, ThreadPool& threads);
  // Sets the runs of a group, and makes room for them; pairs of tile t are [first[t], first[t + 1]).
  template <class Pairs, class Choice>
  void set_runs(PairGroup& group, const Pairs& pairs, const std::vector<std::size_t>& first,
                const Choice& choice, ThreadPool& threads);
  // Behind the pairs of a run.
  void write_padding(const PairGroup& group, const PairRun& run);
  // The same for pairs in any order; the histories are to be moved.
  std::vector<PairColumns::Move> fill_unsorted(PairGroup& group, std::vector<Listed>& pairs);
  void set_pair(std::size_t index, std::uint32_t first, std::uint32_t second, std::uint8_t code) {
    a[index] = first, b[index] = second, image[index] = code;
  }
  void set_wall(std::size_t index, const PlanePair& p) {
    set_pair(index, p.body, p.plane, image_of_spot(p.spot));
  }
  // The pairs of a group that come to this rank.
  struct Arrived;
  Arrived exchange_group(class Ranks& ranks, const class TileOwners& owners, const PairGroup& group,
                         const PairColumns& further, std::uint32_t width) const;
  void carry_histories(ThreadPool& threads);
  // Behind the bodies of a tile; without tiles, behind all.
  std::size_t end_of(std::size_t tile) const {
    return tile + 1 == tiles_.count() ? std::numeric_limits<std::size_t>::max() : tiles_[tile].end;
  }
  // The pairs of a group in a state; return the row of each in the group.
  std::vector<std::uint32_t> save_pairs(const class StateTransfer& state, const PairGroup& group,
                                        const BodyOrder& order) const;
  std::vector<std::uint32_t> restore_pairs(const class StateTransfer& state, PairGroup& group,
                                           const BodyOrder& order, std::size_t planes);
  static void transfer_columns(const class StateTransfer& state, const std::string& name, const char* unit,
                               PairColumns& columns, const std::vector<std::uint32_t>& storage);
  // A group before the last rebuild; its memory is reused by the next.
  struct Before {
    std::size_t begin = 0;
    std::vector<PairRun> runs = {};
    PairColumns history, spots;
  };

  // Adds the rows of the pairs [q, q_end) that were among [p, p_end) before; both are sorted.
  void add_kept_rows(const Before& before, const PairGroup& now, std::size_t p, std::size_t p_end,
                     std::size_t q, std::size_t q_end, std::vector<PairColumns::Move>& rows) const;

  BodyTiles tiles_;
  std::vector<PairGroup> groups_;
  std::vector<Before> before_;
  Column<std::uint32_t> before_a_, before_b_;
  Column<std::uint8_t> before_image_;
  std::vector<std::vector<PairColumns::Move>> kept_rows_;  // of each tile
  std::uint64_t revision_ = 0;
};

}  // namespace scree
