#include "over_ranks.hpp"
#include "ranks/balanced_owners.hpp"
#include "sanitized.hpp"
#include "state/heap.hpp"
#include "step/sliding_layers.hpp"

#include <catch2/catch.hpp>

#include <scree/simulation.hpp>

// Scenes whose tiles are dealt as a partitioner proposes.

using scree::Ranks;
using scree::Scene;
using scree::Simulation;
using scree::State;
using scree::TileGraph;
using scree::TileMap;
using scree::test::check_same;
using scree::test::over_ranks;
using scree::test::sliding_layers;

namespace {

constexpr int steps_as_proposed = scree::test::fewer_if_sanitized(60);

// How often the rank changes from a tile to the next.
unsigned changes_in(const TileMap& map) {
  unsigned changes = 0;
  for (std::size_t tile = 1; tile < map.size(); ++tile) changes += map[tile] != map[tile - 1];
  return changes;
}

// Of all maps that are better than consecutive tiles, or of all others, one with the fewest pairs across; the
// tiles of some rank do not follow each other.
TileMap best_map(const TileGraph& graph, unsigned ranks, bool better) {
  const TileMap ranges = scree::ranges_of_tiles(graph.work, ranks);
  TileMap map(ranges.size(), 0), best;
  for (std::size_t k = 0; k < map.size();) {
    if (changes_in(map) >= ranks && scree::is_better(graph, map, ranges, ranks) == better &&
        (best.empty() || scree::pairs_across(graph, map) < scree::pairs_across(graph, best)))
      best = map;
    for (k = 0; k < map.size() && ++map[k] == ranks; ++k) map[k] = 0;
  }
  return best;
}

struct Outcome {
  State state;
  bool by_graph = false;
  TileMap proposed;
};

Outcome over_partition(const Scene& scene, unsigned ranks, bool better) {
  Outcome outcome;
  over_ranks(
      ranks, false,
      [&](Ranks& all) {
        Simulation s(scene, &all);
        s.run(steps_as_proposed, [] { return true; });
        outcome.by_graph = s.footprint().by_graph;
        outcome.state = s.state();
      },
      [&](const TileGraph& graph) { return outcome.proposed = best_map(graph, ranks, better); });
  return outcome;
}

}  // namespace

TEST_CASE("tiles that a partitioner has dealt give the same bits", "[ranks]") {
  for (const int dimension : {2, 3}) {
    const Scene scene = sliding_layers(dimension, 2);
    Simulation s(scene);
    s.run(steps_as_proposed, [] { return true; });
    const State alone = s.state();
    CHECK(!s.footprint().by_graph);
    const unsigned ranks = unsigned(dimension);
    for (const bool better : {true, false}) {
      if (dimension == 2 && better) continue;  // no map of its few tiles is clearly better than ranges
      INFO(dimension << "D, " << ranks << " ranks, better: " << better);
      const Outcome outcome = over_partition(scene, ranks, better);
      REQUIRE(!outcome.proposed.empty());
      CHECK(outcome.by_graph == better);
      check_same(outcome.state, alone);
    }
  }
}
