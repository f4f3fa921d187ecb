#include "ranks/balanced_owners.hpp"

#include "ranks/messages.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace scree {

namespace {

// Of the work of the busiest rank, for which fewer pairs across do not make up.
constexpr double more_work = 1.05;

// Pairs across by which a map must be better: tiles that are dealt anew take time and memory.
constexpr double fewer_pairs = 0.97;

// With fewer tiles a rank there is nothing to choose: whole tiles cannot be balanced otherwise.
constexpr std::size_t least_tiles = 3;

// All edges, on the first rank.
std::vector<TileGraph::Edge> gather_edges(Ranks& ranks, std::vector<TileGraph::Edge> own) {
  std::vector<std::vector<TileGraph::Edge>> sent(ranks.size());
  sent[0] = std::move(own);
  std::vector<TileGraph::Edge> all;
  for (const std::vector<TileGraph::Edge>& edges : exchange_items(ranks, std::move(sent)))
    all.insert(all.end(), edges.begin(), edges.end());
  // As if one rank had all tiles, so that a partitioner does not see which rank has which.
  std::sort(all.begin(), all.end(), [](const TileGraph::Edge& one, const TileGraph::Edge& other) {
    return std::pair(one.tile, one.other) < std::pair(other.tile, other.other);
  });
  return all;
}

}  // namespace

TileOwners balanced_owners(Ranks& ranks, TileGraph own) {
  TileGraph graph = std::move(own);
  ranks.combine(graph.work, {});
  TileMap map = ranges_of_tiles(graph.work, ranks.size());
  if (ranks.size() == 1 || map.size() < least_tiles * ranks.size()) return {std::move(map), ranks.rank()};
  graph.edges = gather_edges(ranks, std::move(graph.edges));
  bool by_graph = false;
  if (ranks.rank() == 0 && !graph.edges.empty()) {
    TileMap found = in_order_of_tiles(ranks.partition(graph), ranks.size());
    by_graph = !found.empty() && is_better(graph, found, map, ranks.size());
    if (by_graph) map = std::move(found);
  }
  ranks.broadcast(std::as_writable_bytes(std::span(&by_graph, 1)));
  ranks.broadcast(std::as_writable_bytes(std::span(map)));
  return {std::move(map), ranks.rank(), by_graph};
}

TileMap ranges_of_tiles(const std::vector<double>& work, unsigned ranks) {
  const double all = std::accumulate(work.begin(), work.end(), 0.0);
  TileMap map(work.size());
  double before = 0;
  for (std::size_t tile = 0; tile < work.size(); ++tile) {
    const double middle = before + 0.5 * work[tile];
    map[tile] = std::min(ranks - 1, std::uint32_t(ranks * middle / all));
    before += work[tile];
  }
  return map;
}

std::uint64_t pairs_across(const TileGraph& graph, const TileMap& map) {
  std::uint64_t pairs = 0;
  for (const TileGraph::Edge& edge : graph.edges)
    if (map[edge.tile] != map[edge.other]) pairs += edge.pairs;
  return pairs;
}

double largest_work(const TileGraph& graph, const TileMap& map, unsigned ranks) {
  std::vector<double> of_rank(ranks, 0);
  for (std::size_t tile = 0; tile < map.size(); ++tile) of_rank[map[tile]] += graph.work[tile];
  return *std::max_element(of_rank.begin(), of_rank.end());
}

bool is_better(const TileGraph& graph, const TileMap& map, const TileMap& than, unsigned ranks) {
  const double work = largest_work(graph, map, ranks), other_work = largest_work(graph, than, ranks);
  if (work > more_work * other_work) return false;
  return double(pairs_across(graph, map)) < fewer_pairs * double(pairs_across(graph, than)) ||
         other_work > more_work * work;
}

// So that ranks of one machine have tiles near each other, and tiles that are dealt anew mostly stay.
TileMap in_order_of_tiles(const TileMap& map, unsigned ranks) {
  std::vector<double> sum(ranks, 0), count(ranks, 0);
  for (std::size_t tile = 0; tile < map.size(); ++tile) sum[map[tile]] += double(tile), ++count[map[tile]];
  const auto mean = [&](std::uint32_t rank) { return sum[rank] / std::max(1.0, count[rank]); };
  std::vector<std::uint32_t> order(ranks), place(ranks);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t one, std::uint32_t other) { return mean(one) < mean(other); });
  for (std::uint32_t k = 0; k < ranks; ++k) place[order[k]] = k;
  TileMap renumbered;
  for (const std::uint32_t rank : map) renumbered.push_back(place[rank]);
  return renumbered;
}

}  // namespace scree
