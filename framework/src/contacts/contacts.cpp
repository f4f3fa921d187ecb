#include "contacts/contacts.hpp"

#include "bodies/counting_sort.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <tuple>
#include <utility>

#include <scree/domain.hpp>

namespace scree {

namespace {

std::uint64_t key(std::uint32_t first, std::uint32_t second) { return std::uint64_t(first) << 32 | second; }

// Image of the pair (b, a) for the image of (a, b).
std::uint8_t reversed(std::uint8_t image) { return std::uint8_t(2 * Domain::no_shift - image); }

}  // namespace

Contacts::Contacts(const std::vector<Kind>& kinds, BodyTiles tiles) : tiles_(tiles) {
  for (const Kind& kind : kinds) {
    PairGroup group;
    group.law = kind.law;
    group.planes = kind.planes;
    group.history_width = kind.history_width;
    before_.push_back({0, {}, group.history});
    groups_.push_back(std::move(group));
  }
}

std::uint64_t Contacts::place_key(bool planes, std::uint32_t a, std::uint32_t b) {
  return planes ? key(a, b) : key(std::min(a, b), std::max(a, b));
}

template <class Pairs, class First, class Second, class Take>
void Contacts::fill(PairGroup& group, const Pairs& pairs, const First& first, const Second& second,
                    const Take& take) {
  group.begin = group.end = a.size();
  group.pairs = 0;
  group.runs.clear();
  std::vector<std::size_t> crossing;
  std::size_t next = 0;
  for (std::size_t t = 0; t < tiles_.count(); ++t) {
    const std::size_t end = t + 1 == tiles_.count() ? std::numeric_limits<std::size_t>::max() : tiles_[t].end;
    crossing.clear();
    PairRun run = {.begin = a.size()};
    for (; next < pairs.size() && first(pairs[next]) < end; ++next)
      if (second(pairs[next]) < end)
        take(pairs[next]);
      else
        crossing.push_back(next);
    run.crossing = a.size();
    for (const std::size_t pair : crossing) take(pairs[pair]);
    close_run(group, run);
  }
  group.history.reset(group.history_width, group.padded_size());
}

void Contacts::close_run(PairGroup& group, PairRun run) {
  run.end = a.size();
  group.runs.push_back(run);
  if (run.end > run.begin) group.end = run.end;
  group.pairs += run.end - run.begin;
  while (a.size() % SCREE_LANES) append_pair(a.back(), group.planes ? 0 : a.back(), Domain::no_shift);
}

void Contacts::rebuild(const std::vector<NeighbourPair>& bodies, const std::vector<PlanePair>& planes,
                       const Lookup& lookup, const BodyOrder& order) {
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
    before_[g].begin = group.begin;
    std::swap(before_[g].runs, group.runs);
    std::swap(before_[g].history, group.history);
    const auto take_plane = [&](const PlanePair& p) {
      if (law_of(lookup.body_material[p.body], lookup.plane_material[p.plane]) == group.law)
        append_pair(p.body, p.plane, Domain::no_shift);
    };
    const auto take_bodies = [&](const NeighbourPair& p) {
      const bool turned = order.number(p.a) > order.number(p.b);
      const std::uint32_t first = turned ? p.b : p.a, second = turned ? p.a : p.b;
      if (law_of(lookup.body_material[first], lookup.body_material[second]) == group.law)
        append_pair(first, second, turned ? reversed(p.image) : p.image);
    };
    const auto body_of = [](const PlanePair& p) { return p.body; };
    if (group.planes)
      fill(group, planes, body_of, body_of, take_plane);
    else
      fill(
          group, bodies, [](const NeighbourPair& p) { return p.a; },
          [](const NeighbourPair& p) { return p.b; }, take_bodies);
  }
  carry_histories();
  ++revision_;
}

std::vector<PairColumns::Move> Contacts::fill_unsorted(PairGroup& group, std::vector<Listed>& pairs) {
  const auto key_of = [&](const Listed& p) { return place_key(group.planes, p.a, p.b); };
  std::sort(pairs.begin(), pairs.end(),
            [&](const Listed& p, const Listed& q) { return key_of(p) < key_of(q); });
  std::vector<PairColumns::Move> rows;
  const auto first = [&](const Listed& p) { return group.planes ? p.a : std::min(p.a, p.b); };
  const auto second = [&](const Listed& p) { return group.planes ? p.a : std::max(p.a, p.b); };
  fill(group, pairs, first, second, [&](const Listed& p) {
    rows.push_back({p.row, std::uint32_t(a.size() - group.begin)});
    append_pair(p.a, p.b, p.image);
  });
  return rows;
}

void Contacts::rearrange(const std::vector<std::uint32_t>& from) {
  const std::vector<std::uint32_t> to = inverse_of(from);
  const Column<std::uint32_t> old_a = std::exchange(a, {}), old_b = std::exchange(b, {});
  const Column<std::uint8_t> old_image = std::exchange(image, {});
  for (PairGroup& group : groups_) {
    std::vector<Listed> pairs;
    pairs.reserve(group.pairs);
    group.each_pair([&](std::size_t q) {
      pairs.push_back({to[old_a[q]], group.planes ? old_b[q] : to[old_b[q]], old_image[q],
                       std::uint32_t(q - group.begin)});
    });
    const PairColumns history = std::exchange(group.history, {});
    const std::vector<PairColumns::Move> rows = fill_unsorted(group, pairs);
    group.history.take(history, rows);
  }
  ++revision_;
}

double Contacts::crossing_share() const {
  double pairs = 0, crossing = 0;
  for (const PairGroup& group : groups_) {
    if (group.planes) continue;
    pairs += double(group.pairs);
    for (const PairRun& run : group.runs) crossing += double(run.end - run.crossing);
  }
  return pairs > 0 ? crossing / pairs : 0;
}

double Contacts::crossing_share(const std::vector<std::uint32_t>& from) const {
  std::vector<std::uint32_t> tile(from.size());
  for (std::size_t place = 0; place < from.size(); ++place)
    tile[from[place]] = std::uint32_t(tiles_.owner(place));
  double pairs = 0, crossing = 0;
  for (const PairGroup& group : groups_) {
    if (group.planes) continue;
    pairs += double(group.pairs);
    group.each_pair([&](std::size_t q) { crossing += tile[a[q]] != tile[b[q]]; });
  }
  return pairs > 0 ? crossing / pairs : 0;
}

std::vector<std::size_t> Contacts::in_scene_order(const PairGroup& group, const BodyOrder& order) const {
  std::vector<std::size_t> pairs(group.pairs);
  if (group.pairs == 0) return pairs;
  std::vector<std::uint32_t> first;
  counting_sort(
      tiles_.size() + 1, first, [&](const auto& visit) { group.each_pair(visit); },
      [&](std::size_t q) { return tiles_.count() == 1 && !order.rearranged() ? 0 : order.number(a[q]); },
      [&](std::size_t q, std::size_t index) { pairs[index] = q; });
  const auto second = [&](std::size_t q) { return group.planes ? b[q] : order.number(b[q]); };
  if (tiles_.count() == 1 && !order.rearranged()) return pairs;
  for (std::size_t k = 0; k + 1 < first.size(); ++k)
    std::sort(pairs.begin() + first[k], pairs.begin() + first[k + 1],
              [&](std::size_t p, std::size_t q) { return second(p) < second(q); });
  return pairs;
}

void Contacts::clear_histories() {
  for (PairGroup& group : groups_) group.history.reset(group.history_width, group.padded_size());
}

void Contacts::append(std::size_t group, const std::vector<PlanePair>& pairs) {
  const auto body_of = [](const PlanePair& p) { return p.body; };
  fill(groups_[group], pairs, body_of, body_of,
       [&](const PlanePair& p) { append_pair(p.body, p.plane, Domain::no_shift); });
}

Contacts::Place Contacts::find(bool plane, std::uint32_t first, std::uint32_t second,
                               const BodyOrder& order) {
  const std::uint32_t one = order.place(first), other = plane ? second : order.place(second);
  const std::uint64_t wanted = place_key(plane, one, other);
  const std::size_t tile = tiles_.owner(plane ? one : std::min(one, other));
  const bool crosses = !plane && tiles_.owner(std::max(one, other)) != tile;
  for (PairGroup& group : groups_) {
    if (group.planes != plane || group.runs.empty()) continue;
    const PairRun& run = group.runs[tile];
    const std::size_t end = crosses ? run.end : run.crossing;
    std::size_t low = crosses ? run.crossing : run.begin, high = end;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      place_key(plane, a[middle], b[middle]) < wanted ? low = middle + 1 : high = middle;
    }
    if (low < end && place_key(plane, a[low], b[low]) == wanted) return {&group, low - group.begin};
  }
  return {nullptr, 0};
}

void Contacts::carry_history(const Before& before, const PairGroup& now, std::size_t p, std::size_t p_end,
                             std::size_t q, std::size_t q_end) {
  for (; q < q_end; ++q) {
    const std::uint64_t pair = place_key(now.planes, a[q], b[q]);
    while (p < p_end && place_key(now.planes, before_a_[p], before_b_[p]) < pair) ++p;
    if (p == p_end) break;
    if (before_a_[p] == a[q] && before_b_[p] == b[q])
      kept_rows_.push_back({std::uint32_t(p - before.begin), std::uint32_t(q - now.begin)});
  }
}

void Contacts::carry_histories() {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& now = groups_[g];
    const Before& before = before_[g];
    if (now.history_width == 0 || before.history.width() == 0) continue;
    kept_rows_.clear();
    for (std::size_t t = 0; t < now.runs.size(); ++t) {
      const PairRun &from = before.runs[t], &to = now.runs[t];
      carry_history(before, now, from.begin, from.crossing, to.begin, to.crossing);
      carry_history(before, now, from.crossing, from.end, to.crossing, to.end);
    }
    now.history.take(before.history, kept_rows_);
  }
}

}  // namespace scree
