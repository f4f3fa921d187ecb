#include "metis_partition.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <metis.h>
#include <numeric>

#include <scree/kept_handlers.hpp>

namespace scree::ranks {
namespace {

// METIS adds weights up in idx_t, which may have 32 bits.
constexpr double largest_sum = 1e9;

// Each edge from both of its tiles; tile t has the edges [start[t], start[t + 1]).
struct Adjacency {
  std::vector<idx_t> start, neighbours, pairs;
};

Adjacency adjacency_of(const TileGraph& graph) {
  const std::size_t tiles = graph.work.size();
  double sum = 0;
  Adjacency of{std::vector<idx_t>(tiles + 1, 0), std::vector<idx_t>(2 * graph.edges.size()), {}};
  of.pairs.resize(of.neighbours.size());
  for (const TileGraph::Edge& edge : graph.edges) {
    ++of.start[edge.tile + 1], ++of.start[edge.other + 1];
    sum += 2.0 * edge.pairs;
  }
  std::partial_sum(of.start.begin(), of.start.end(), of.start.begin());
  const double scale = std::min(1.0, largest_sum / std::max(1.0, sum));
  std::vector<idx_t> next(of.start.begin(), of.start.end() - 1);
  const auto add = [&](std::uint32_t tile, std::uint32_t other, std::uint32_t pairs) {
    const auto k = std::size_t(next[tile]++);
    of.neighbours[k] = idx_t(other), of.pairs[k] = std::max<idx_t>(1, idx_t(scale * pairs));
  };
  for (const TileGraph::Edge& edge : graph.edges)
    add(edge.tile, edge.other, edge.pairs), add(edge.other, edge.tile, edge.pairs);
  return of;
}

std::vector<idx_t> weights_of(const std::vector<double>& work) {
  const double sum = std::accumulate(work.begin(), work.end(), 0.0);
  std::vector<idx_t> weights;
  for (const double of_tile : work)
    weights.push_back(std::max<idx_t>(1, sum > 0 ? idx_t(largest_sum / 10 * of_tile / sum) : 1));
  return weights;
}

}  // namespace

std::vector<std::uint32_t> metis_partition(const TileGraph& graph, unsigned ranks) {
  Adjacency adjacency = adjacency_of(graph);
  std::vector<idx_t> weights = weights_of(graph.work), rank_of(weights.size(), 0);
  std::array<idx_t, METIS_NOPTIONS> options = {};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_NCUTS] = 8;     // of which it takes the best
  options[METIS_OPTION_UFACTOR] = 50;  // each half may have 5 % more than its share
  idx_t tiles = idx_t(weights.size()), constraints = 1, parts = idx_t(ranks), cut = 0;
  int status = METIS_OK;
  {
    const KeptHandlers kept;
    // Better balanced than METIS_PartGraphKway, with as few pairs across.
    status = METIS_PartGraphRecursive(
        &tiles, &constraints, adjacency.start.data(), adjacency.neighbours.data(), weights.data(), nullptr,
        adjacency.pairs.data(), &parts, nullptr, nullptr, options.data(), &cut, rank_of.data());
  }
  // What has stopped METIS is SIGTERM, a request to the program.
  if (status == METIS_ERROR) raise(SIGTERM);
  if (status != METIS_OK) return {};
  return {rank_of.begin(), rank_of.end()};
}

}  // namespace scree::ranks
