#include <algorithm>
#include <tuple>

#include <scree/contacts.hpp>

namespace scree {

namespace {

constexpr std::size_t pad(std::size_t n) { return (n + SCREE_LANES - 1) / SCREE_LANES * SCREE_LANES; }

}  // namespace

Contacts::Contacts(const std::vector<Kind>& kinds, Precision precision) {
  for (const Kind& kind : kinds) {
    PairGroup group;
    group.law = kind.law;
    group.planes = kind.planes;
    group.history_width = kind.history_width;
    group.history = PairColumns(precision);
    groups_.push_back(std::move(group));
  }
}

void Contacts::rebuild(const std::vector<NeighbourPair>& bodies, const std::vector<PlanePair>& planes,
                       const Lookup& lookup) {
  const auto law_of = [&](std::uint32_t material_a, std::uint32_t material_b) {
    return lookup.law_of[material_a * lookup.materials + material_b];
  };
  const std::vector<PairGroup> old = groups_;
  const Column<std::uint32_t> old_a = std::move(a), old_b = std::move(b);
  a.clear(), b.clear(), image.clear();

  for (PairGroup& group : groups_) {
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
    group.end = a.size();
    while (a.size() % SCREE_LANES) take(a.back(), group.planes ? 0 : a.back(), Domain::no_shift);
    group.history.reset(group.history_width, group.padded_size());
  }
  carry_history(old, old_a, old_b);
  ++revision_;
}

void Contacts::carry_history(const std::vector<PairGroup>& old, const Column<std::uint32_t>& old_a,
                             const Column<std::uint32_t>& old_b) {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& now = groups_[g];
    const PairGroup& before = old[g];
    // A stage may have changed how much a law keeps; what both know is carried.
    const std::uint32_t width = std::min(now.history_width, before.history.width());
    std::size_t p = before.begin;
    for (std::size_t q = now.begin; q < now.end && width > 0; ++q) {
      while (p < before.end && std::tie(old_a[p], old_b[p]) < std::tie(a[q], b[q])) ++p;
      if (p == before.end) break;
      if (old_a[p] != a[q] || old_b[p] != b[q]) continue;
      for (std::uint32_t k = 0; k < width; ++k) now.history.set(k, q - now.begin, before.history_of(p, k));
    }
  }
}

}  // namespace scree
