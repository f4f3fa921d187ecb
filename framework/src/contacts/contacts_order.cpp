#include "bodies/counting_sort.hpp"
#include "contacts/contacts.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

// Pairs by the places of their bodies in memory, and by their numbers.
namespace scree {

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
    const PairColumns history = std::exchange(group.history, {}), spots = std::exchange(group.spots, {});
    const std::vector<PairColumns::Move> rows = fill_unsorted(group, pairs);
    group.history.take(history, rows);
    group.spots.take(spots, rows);
  }
  ++revision_;
}

std::size_t Contacts::listed() const {
  std::size_t pairs = 0;
  for (const PairGroup& group : groups_) pairs += group.pairs;
  return pairs;
}

CrossingPairs Contacts::crossing() const {
  CrossingPairs pairs;
  for (const PairGroup& group : groups_) {
    if (group.planes) continue;
    pairs.all += std::int64_t(group.pairs);
    for (const PairRun& run : group.runs) pairs.crossing += std::int64_t(run.end - run.crossing);
  }
  return pairs;
}

CrossingPairs Contacts::crossing(const std::vector<std::uint32_t>& from) const {
  std::vector<std::uint32_t> tile(from.size());
  for (std::size_t place = 0; place < from.size(); ++place)
    tile[from[place]] = std::uint32_t(tiles_.owner(place));
  CrossingPairs pairs;
  for (const PairGroup& group : groups_) {
    if (group.planes) continue;
    pairs.all += std::int64_t(group.pairs);
    group.each_pair([&](std::size_t q) { pairs.crossing += tile[a[q]] != tile[b[q]]; });
  }
  return pairs;
}

std::vector<TileGraph::Edge> Contacts::edges_of_tiles() const {
  std::vector<TileGraph::Edge> edges;
  std::vector<std::uint32_t> pairs_with(tiles_.count(), 0), reached;
  for (std::uint32_t tile = 0; tile < tiles_.count(); ++tile) {
    for (const PairGroup& group : groups_) {
      if (group.planes || group.runs.empty()) continue;
      for (std::size_t q = group.runs[tile].crossing; q < group.runs[tile].end; ++q) {
        const auto other = std::uint32_t(tiles_.owner(std::max(a[q], b[q])));
        if (pairs_with[other]++ == 0) reached.push_back(other);
      }
    }
    std::sort(reached.begin(), reached.end());
    for (const std::uint32_t other : reached)
      edges.push_back({tile, other, std::exchange(pairs_with[other], 0)});
    reached.clear();
  }
  return edges;
}

std::vector<std::size_t> Contacts::in_scene_order(const PairGroup& group, const BodyOrder& order) const {
  std::vector<std::size_t> pairs(group.pairs);
  if (group.pairs == 0) return pairs;
  std::vector<std::uint32_t> first;
  counting_sort(
      tiles_.size() + 1, first, [&](const auto& visit) { group.each_pair(visit); },
      [&](std::size_t q) { return tiles_.count() == 1 && !order.rearranged() ? 0 : order.number(a[q]); },
      [&](std::size_t q, std::size_t index) { pairs[index] = q; });
  const auto second = [&](std::size_t q) {
    return std::tuple(group.planes ? b[q] : order.number(b[q]), image[q]);
  };
  if (tiles_.count() == 1 && !order.rearranged()) return pairs;
  for (std::size_t k = 0; k + 1 < first.size(); ++k)
    std::sort(pairs.begin() + first[k], pairs.begin() + first[k + 1],
              [&](std::size_t p, std::size_t q) { return second(p) < second(q); });
  return pairs;
}

Contacts::Place Contacts::find(bool plane, std::uint32_t first, std::uint32_t second, const BodyOrder& order,
                               std::uint32_t spot) {
  const std::uint32_t one = order.place(first), other = plane ? second : order.place(second);
  const std::uint64_t wanted = place_key(plane, one, other, image_of_spot(spot));
  const std::size_t tile = tiles_.owner(plane ? one : std::min(one, other));
  const bool crosses = !plane && tiles_.owner(std::max(one, other)) != tile;
  for (PairGroup& group : groups_) {
    if (group.planes != plane || group.runs.empty()) continue;
    const PairRun& run = group.runs[tile];
    const std::size_t end = crosses ? run.end : run.crossing;
    std::size_t low = crosses ? run.crossing : run.begin, high = end;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      place_key(plane, a[middle], b[middle], image[middle]) < wanted ? low = middle + 1 : high = middle;
    }
    if (low < end && place_key(plane, a[low], b[low], image[low]) == wanted)
      return {&group, low - group.begin};
  }
  return {nullptr, 0};
}

}  // namespace scree
