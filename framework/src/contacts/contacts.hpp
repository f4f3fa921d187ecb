#pragma once

#include "contacts/pair_columns.hpp"

#include <cstdint>
#include <vector>

#include <scree/column.hpp>
#include <scree/pair_search.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// Candidate pair of a body and a plane.
struct PlanePair {
  std::uint32_t body, plane;
};

// Candidate pairs with the same law and the same kind of partner: a contiguous range of the pair arrays.
struct PairGroup {
  std::uint32_t law = 0;
  bool planes = false;    // b is a plane
  std::size_t begin = 0;  // multiple of SCREE_LANES
  std::size_t end = 0;    // behind the last real pair; padded to the next multiple of SCREE_LANES
  std::uint32_t history_width = 0;
  PairColumns history = PairColumns();  // (width, padded size), zero where the pair does not touch

  std::size_t padded_size() const { return (end - begin + SCREE_LANES - 1) / SCREE_LANES * SCREE_LANES; }
  // History value k of a pair, which is numbered over all groups.
  double history_of(std::size_t pair, std::uint32_t k) const { return history.value(k, pair - begin); }
};

// All candidate pairs of a scene in a fixed order, with the histories of their laws. The pairs change only in
// a neighbour search; a pair touches while its overlap is positive.
class Contacts {
 public:
  // A combination of law and kind of partner that gets a group; groups are empty until `rebuild`.
  struct Kind {
    std::uint32_t law;
    bool planes;
    std::uint32_t history_width;
  };
  // Tables for finding the law of a pair: law_of[material_a * materials + material_b].
  struct Lookup {
    const std::uint32_t* law_of = nullptr;
    std::uint32_t materials = 0;
    const std::uint32_t* body_material = nullptr;
    const std::uint32_t* plane_material = nullptr;
  };

  explicit Contacts(const std::vector<Kind>& kinds = {}, Precision precision = Precision::double_precision);

  // Replaces the pairs (sorted by a, b) and keeps the histories of pairs that existed before.
  void rebuild(const std::vector<NeighbourPair>& bodies, const std::vector<PlanePair>& planes,
               const Lookup& lookup);

  // Sets all histories to 0, as of pairs that do not touch.
  void clear_histories();

  // Fills a group of pairs with planes, which must be the next empty one, with history 0. For pairs that are
  // not replaced by `rebuild`.
  void append(std::size_t group, const std::vector<PlanePair>& pairs);

  // Pairs and histories, with as many bodies and planes as the scene has.
  void transfer(const class StateTransfer& state, std::size_t bodies, std::size_t planes);

  // The group of a pair and its row there; no group if it is not listed.
  struct Place {
    PairGroup* group;
    std::size_t row;
  };
  Place find(bool plane, std::uint32_t first, std::uint32_t second);

  std::vector<PairGroup>& groups() { return groups_; }
  const std::vector<PairGroup>& groups() const { return groups_; }
  std::size_t padded_size() const { return a.size(); }

  Column<std::uint32_t> a, b;  // padding: the last a of its group with itself, or with the first plane
  Column<std::uint8_t> image;

  // Number of rebuilds; data derived from the pairs is recomputed when it changes.
  std::uint64_t revision() const { return revision_; }

 private:
  void carry_history();
  void append_padding(PairGroup& group);

  // A group before the last rebuild; its memory is reused by the next.
  struct Before {
    std::size_t begin = 0, end = 0;
    PairColumns history = PairColumns();
  };

  std::vector<PairGroup> groups_;
  std::vector<Before> before_;
  Column<std::uint32_t> before_a_, before_b_;
  std::vector<PairColumns::Move> kept_rows_;
  std::uint64_t revision_ = 0;
};

}  // namespace scree
