#include "contacts/contacts.hpp"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include <scree/domain.hpp>

namespace scree {

namespace {

std::uint64_t key(std::uint32_t first, std::uint32_t second) { return std::uint64_t(first) << 32 | second; }

constexpr std::size_t pad(std::size_t n) { return (n + SCREE_LANES - 1) / SCREE_LANES * SCREE_LANES; }

}  // namespace

Contacts::Contacts(const std::vector<Kind>& kinds, Precision precision) {
  for (const Kind& kind : kinds) {
    PairGroup group;
    group.law = kind.law;
    group.planes = kind.planes;
    group.history_width = kind.history_width;
    group.history = PairColumns(precision);
    before_.push_back({0, 0, group.history});
    groups_.push_back(std::move(group));
  }
}

void Contacts::rebuild(const std::vector<NeighbourPair>& bodies, const std::vector<PlanePair>& planes,
                       const Lookup& lookup) {
  assert(std::is_sorted(bodies.begin(), bodies.end(), [](const NeighbourPair& p, const NeighbourPair& q) {
    return std::tie(p.a, p.b) < std::tie(q.a, q.b);
  }));
  const auto law_of = [&](std::uint32_t material_a, std::uint32_t material_b) {
    return lookup.law_of[material_a * lookup.materials + material_b];
  };
  std::swap(a, before_a_), std::swap(b, before_b_);
  a.clear(), b.clear(), image.clear();

  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& group = groups_[g];
    before_[g].begin = group.begin, before_[g].end = group.end;
    std::swap(before_[g].history, group.history);
    group.begin = a.size();
    const auto take = [&](std::uint32_t first, std::uint32_t second, std::uint8_t code) {
      a.push_back(first), b.push_back(second), image.push_back(code);
    };
    if (group.planes) {
      for (const PlanePair& p : planes)
        if (law_of(lookup.body_material[p.body], lookup.plane_material[p.plane]) == group.law)
          take(p.body, p.plane, Domain::no_shift);
    } else {
      for (const NeighbourPair& p : bodies)
        if (law_of(lookup.body_material[p.a], lookup.body_material[p.b]) == group.law)
          take(p.a, p.b, p.image);
    }
    append_padding(group);
  }
  carry_history();
  ++revision_;
}

void Contacts::clear_histories() {
  for (PairGroup& group : groups_) group.history.reset(group.history_width, group.padded_size());
}

void Contacts::append(std::size_t group, const std::vector<PlanePair>& pairs) {
  groups_[group].begin = a.size();
  for (const PlanePair& p : pairs)
    a.push_back(p.body), b.push_back(p.plane), image.push_back(Domain::no_shift);
  append_padding(groups_[group]);
}

void Contacts::append_padding(PairGroup& group) {
  group.end = a.size();
  while (a.size() % SCREE_LANES)
    a.push_back(a.back()), b.push_back(group.planes ? 0 : a.back()), image.push_back(Domain::no_shift);
  group.history.reset(group.history_width, group.padded_size());
}

Contacts::Place Contacts::find(bool plane, std::uint32_t first, std::uint32_t second) {
  for (PairGroup& group : groups_) {
    if (group.planes != plane) continue;
    std::size_t low = group.begin, high = group.end;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      key(a[middle], b[middle]) < key(first, second) ? low = middle + 1 : high = middle;
    }
    if (low < group.end && key(a[low], b[low]) == key(first, second)) return {&group, low - group.begin};
  }
  return {nullptr, 0};
}

void Contacts::carry_history() {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& now = groups_[g];
    const Before& before = before_[g];
    if (now.history_width == 0 || before.history.width() == 0) continue;
    kept_rows_.clear();
    std::size_t p = before.begin;
    for (std::size_t q = now.begin; q < now.end; ++q) {
      const std::uint64_t pair = key(a[q], b[q]);
      while (p < before.end && key(before_a_[p], before_b_[p]) < pair) ++p;
      if (p == before.end) break;
      if (key(before_a_[p], before_b_[p]) == pair)
        kept_rows_.push_back({std::uint32_t(p - before.begin), std::uint32_t(q - now.begin)});
    }
    now.history.take(before.history, kept_rows_);
  }
}

}  // namespace scree
