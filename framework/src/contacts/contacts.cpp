#include "contacts/contacts.hpp"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include <scree/domain.hpp>

namespace scree {

namespace {

// Image of the pair (b, a) for the image of (a, b).
std::uint8_t reversed(std::uint8_t image) { return std::uint8_t(2 * Domain::no_shift - image); }

}  // namespace

Contacts::Contacts(const std::vector<Kind>& kinds, BodyTiles tiles) : tiles_(tiles) {
  for (const Kind& kind : kinds) {
    PairGroup group;
    group.law = kind.law;
    group.planes = kind.planes;
    group.surfaces = kind.surfaces;
    group.history_width = kind.history_width;
    group.spot_width = kind.spot_width;
    before_.push_back({0, {}, group.history, group.spots});
    groups_.push_back(std::move(group));
  }
}

std::uint64_t Contacts::place_key(bool planes, std::uint32_t a, std::uint32_t b, std::uint8_t image) {
  constexpr std::uint64_t images = 32;
  const auto key = [](std::uint64_t first, std::uint64_t second) { return first << 32 | second; };
  return planes ? key(a, images * b + image) : key(std::min(a, b), std::max(a, b));
}

namespace {

// How pairs of a range are taken into a group, see Contacts::fill.
template <class Belongs, class First, class Second, class Write>
struct Choice {
  Belongs belongs;
  First first;
  Second second;
  Write write;
};
template <class Belongs, class First, class Second, class Write>
Choice(Belongs, First, Second, Write) -> Choice<Belongs, First, Second, Write>;

}  // namespace

template <class Pairs, class Choice>
void Contacts::fill(PairGroup& group, const Pairs& pairs, const Choice& choice, ThreadPool& threads) {
  std::vector<std::size_t> first(tiles_.count() + 1);
  first.back() = pairs.size();
  for (std::size_t t = 1; t < tiles_.count(); ++t)
    first[t] = std::size_t(
        std::partition_point(pairs.begin(), pairs.end(),
                             [&](const auto& pair) { return choice.first(pair) < tiles_[t].begin; }) -
        pairs.begin());
  set_runs(group, pairs, first, choice, threads);
  threads.each(tiles_.count(), [&](std::size_t t, unsigned) {
    const PairRun& run = group.runs[t];
    std::size_t inside = run.begin, crossing = run.crossing;
    for (std::size_t k = first[t]; k < first[t + 1]; ++k)
      if (choice.belongs(pairs[k]))
        choice.write(pairs[k], choice.second(pairs[k]) < end_of(t) ? inside++ : crossing++);
    write_padding(group, run);
    for (PairColumns* const columns : {&group.history, &group.spots})
      columns->clear(run.begin - group.begin, run.begin - group.begin + run.padded_size());
  });
}

template <class Pairs, class Choice>
void Contacts::set_runs(PairGroup& group, const Pairs& pairs, const std::vector<std::size_t>& first,
                        const Choice& choice, ThreadPool& threads) {
  group.runs.assign(tiles_.count(), {});
  threads.each(tiles_.count(), [&](std::size_t t, unsigned) {
    PairRun& run = group.runs[t];  // as if it began at 0
    for (std::size_t k = first[t]; k < first[t + 1]; ++k) {
      const bool belongs = choice.belongs(pairs[k]);
      run.end += belongs;
      run.crossing += belongs && choice.second(pairs[k]) < end_of(t);
    }
  });
  group.begin = group.end = a.size();
  group.pairs = 0;
  std::size_t begin = group.begin;
  for (PairRun& run : group.runs) {
    group.pairs += run.end;
    run.begin = begin, run.crossing += begin, run.end += begin;
    if (run.end > run.begin) group.end = run.end;
    begin += run.padded_size();
  }
  resize_with_room(a, begin), resize_with_room(b, begin), resize_with_room(image, begin);
  group.resize_columns();
}

void Contacts::write_padding(const PairGroup& group, const PairRun& run) {
  for (std::size_t q = run.end; q < run.begin + run.padded_size(); ++q)
    set_pair(q, a[run.end - 1], group.planes ? 0 : a[run.end - 1], Domain::no_shift);
}

void Contacts::rebuild(const std::vector<NeighbourPair>& bodies, const std::vector<PlanePair>& planes,
                       const Lookup& lookup, const BodyOrder& order, ThreadPool& threads) {
  assert(std::is_sorted(bodies.begin(), bodies.end(), [](const NeighbourPair& p, const NeighbourPair& q) {
    return std::tie(p.a, p.b) < std::tie(q.a, q.b);
  }));
  const auto law_of = [&](std::uint32_t material_a, std::uint32_t material_b) {
    return lookup.law_of[material_a * lookup.materials + material_b];
  };
  std::swap(a, before_a_), std::swap(b, before_b_), std::swap(image, before_image_);
  a.clear(), b.clear(), image.clear();
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& group = groups_[g];
    before_[g].begin = group.begin;
    std::swap(before_[g].runs, group.runs);
    std::swap(before_[g].history, group.history);
    std::swap(before_[g].spots, group.spots);
    const auto body_of = [](const PlanePair& p) { return p.body; };
    const auto is_turned = [&](const NeighbourPair& p) { return order.number(p.a) > order.number(p.b); };
    const Choice planes_of_group = {
        [&](const PlanePair& p) {
          return (p.plane >= lookup.surfaces_from) == group.surfaces &&
                 law_of(lookup.body_material[p.body], lookup.plane_material[p.plane]) == group.law;
        },
        body_of, body_of, [&](const PlanePair& p, std::size_t index) { set_wall(index, p); }};
    const Choice bodies_of_group = {
        [&](const NeighbourPair& p) {
          if (lookup.materials == 1) return lookup.law_of[0] == group.law;
          const std::uint32_t a_material = lookup.body_material[p.a], b_material = lookup.body_material[p.b];
          return (is_turned(p) ? law_of(b_material, a_material) : law_of(a_material, b_material)) ==
                 group.law;
        },
        [](const NeighbourPair& p) { return p.a; }, [](const NeighbourPair& p) { return p.b; },
        [&](const NeighbourPair& p, std::size_t index) {
          is_turned(p) ? set_pair(index, p.b, p.a, reversed(p.image)) : set_pair(index, p.a, p.b, p.image);
        }};
    group.planes ? fill(group, planes, planes_of_group, threads)
                 : fill(group, bodies, bodies_of_group, threads);
  }
  carry_histories(threads);
  ++revision_;
}

std::vector<PairColumns::Move> Contacts::fill_unsorted(PairGroup& group, std::vector<Listed>& pairs) {
  const auto key_of = [&](const Listed& p) { return place_key(group.planes, p.a, p.b, p.image); };
  std::sort(pairs.begin(), pairs.end(),
            [&](const Listed& p, const Listed& q) { return key_of(p) < key_of(q); });
  std::vector<PairColumns::Move> rows;
  const Choice all = {[](const Listed&) { return true; },
                      [&](const Listed& p) { return group.planes ? p.a : std::min(p.a, p.b); },
                      [&](const Listed& p) { return group.planes ? p.a : std::max(p.a, p.b); },
                      [&](const Listed& p, std::size_t index) {
                        rows.push_back({p.row, std::uint32_t(index - group.begin)});
                        set_pair(index, p.a, p.b, p.image);
                      }};
  ThreadPool alone(1);
  fill(group, pairs, all, alone);
  return rows;
}

void Contacts::clear_histories() {
  for (PairGroup& group : groups_) {
    group.resize_columns();
    for (PairColumns* const columns : {&group.history, &group.spots}) columns->clear(0, group.padded_size());
  }
}

void Contacts::append(std::size_t group, const std::vector<PlanePair>& pairs) {
  const auto body_of = [](const PlanePair& p) { return p.body; };
  const Choice all = {[](const PlanePair&) { return true; }, body_of, body_of,
                      [&](const PlanePair& p, std::size_t index) { set_wall(index, p); }};
  ThreadPool alone(1);
  fill(groups_[group], pairs, all, alone);
}

void Contacts::add_kept_rows(const Before& before, const PairGroup& now, std::size_t p, std::size_t p_end,
                             std::size_t q, std::size_t q_end, std::vector<PairColumns::Move>& rows) const {
  for (; q < q_end; ++q) {
    const auto key_before = [&] {
      return place_key(now.planes, before_a_[p], before_b_[p], before_image_[p]);
    };
    const std::uint64_t pair = place_key(now.planes, a[q], b[q], image[q]);
    while (p < p_end && key_before() < pair) ++p;
    if (p == p_end) break;
    if (key_before() == pair && before_a_[p] == a[q])
      rows.push_back({std::uint32_t(p - before.begin), std::uint32_t(q - now.begin)});
  }
}

void Contacts::carry_histories(ThreadPool& threads) {
  kept_rows_.resize(tiles_.count());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& now = groups_[g];
    const Before& before = before_[g];
    if (before.history.width() + before.spots.width() == 0 || !now.keeps_numbers()) continue;
    threads.each(now.runs.size(), [&](std::size_t t, unsigned) {
      std::vector<PairColumns::Move>& rows = kept_rows_[t];
      const PairRun &from = before.runs[t], &to = now.runs[t];
      rows.clear();
      add_kept_rows(before, now, from.begin, from.crossing, to.begin, to.crossing, rows);
      add_kept_rows(before, now, from.crossing, from.end, to.crossing, to.end, rows);
      now.history.take(before.history, rows);
      now.spots.take(before.spots, rows);
    });
  }
}

}  // namespace scree
