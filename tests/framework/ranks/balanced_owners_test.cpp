#include "ranks/balanced_owners.hpp"

#include "rank_threads.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

// Which rank gets which tile: consecutive tiles, or what a partitioner proposes.

using scree::TileGraph;
using scree::TileMap;
using scree::TileOwners;
using scree::test::RankThreads;

namespace {

constexpr unsigned band_tiles = 12;

// A band of two rows of six tiles, one row after the other, with many pairs between the rows.
TileGraph two_rows() {
  TileGraph graph{std::vector<double>(band_tiles, 1.0), {}};
  for (std::uint32_t k = 0; k + 1 < band_tiles; ++k) {
    graph.edges.push_back({k, k + 1, 10});
    if (k < band_tiles / 2) graph.edges.push_back({k, k + band_tiles / 2, 100});
  }
  return graph;
}

const TileMap both_rows = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
const TileMap across_rows = {0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1};

// The owners that each rank finds. Tile t is of rank t % ranks before.
std::vector<TileOwners> dealt(unsigned ranks, const TileGraph& graph,
                              const RankThreads::Partition& partition) {
  std::vector<TileOwners> owners(ranks);
  RankThreads(ranks, false, partition).run([&](scree::Ranks& all) {
    const unsigned rank = all.rank();
    TileGraph own = graph;
    for (unsigned tile = 0; tile < graph.work.size(); ++tile)
      if (tile % ranks != rank) own.work[tile] = -1;
    std::erase_if(own.edges, [&](const TileGraph::Edge& edge) { return edge.tile % ranks != rank; });
    owners[rank] = scree::balanced_owners(all, own);
  });
  return owners;
}

void check_map(const std::vector<TileOwners>& owners, const TileMap& map, bool by_graph) {
  for (unsigned rank = 0; rank < owners.size(); ++rank) {
    CHECK(owners[rank].by_graph() == by_graph);
    CHECK(owners[rank].rank() == rank);
    for (std::size_t tile = 0; tile < map.size(); ++tile) {
      CHECK(owners[rank].rank_of(tile) == map[tile]);
      CHECK(owners[rank].is_own(tile) == (map[tile] == rank));
    }
  }
}

void check_dealt(const TileGraph& graph, const TileMap& proposed, const TileMap& map, bool by_graph) {
  check_map(dealt(2, graph, [&](const TileGraph&) { return proposed; }), map, by_graph);
}

}  // namespace

TEST_CASE("a map has pairs across and a busiest rank", "[ranks]") {
  TileGraph graph = two_rows();
  CHECK(scree::pairs_across(graph, both_rows) == 610);
  CHECK(scree::pairs_across(graph, across_rows) == 30);
  CHECK(scree::largest_work(graph, both_rows, 2) == 6);
  graph.work[7] = 4;
  CHECK(scree::largest_work(graph, both_rows, 2) == 9);
  CHECK(scree::largest_work(graph, TileMap(band_tiles, 2), 3) == 15);
}

TEST_CASE("consecutive tiles of a rank have its share of the work", "[ranks]") {
  CHECK(scree::ranges_of_tiles(std::vector<double>(band_tiles, 0.3), 2) == both_rows);
  CHECK(scree::ranges_of_tiles({1, 1, 1, 6, 1, 1, 1, 1}, 2) == TileMap{0, 0, 0, 0, 1, 1, 1, 1});
  CHECK(scree::ranges_of_tiles({5}, 3) == TileMap{1});
}

TEST_CASE("tiles are dealt by the map with fewer pairs across", "[ranks]") {
  check_dealt(two_rows(), across_rows, across_rows, true);
  const TileMap alternating = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
  check_dealt(two_rows(), TileMap(alternating.rbegin(), alternating.rend()), alternating, true);
  // Pairs within the rows alone: consecutive tiles are better.
  TileGraph loose = two_rows();
  std::erase_if(loose.edges, [](const TileGraph::Edge& edge) { return edge.pairs > 10; });
  check_dealt(loose, across_rows, both_rows, false);
  // As many pairs, without another reason.
  check_dealt(two_rows(), both_rows, both_rows, false);
  check_dealt(two_rows(), {}, both_rows, false);
}

TEST_CASE("fewer pairs across do not make up for much more work of the busiest rank", "[ranks]") {
  check_dealt(two_rows(), TileMap(band_tiles, 0), both_rows, false);
  TileGraph graph = two_rows();
  graph.work[6] = 1.25, graph.work[9] = 0.75;  // 6 in each row; 6.25 across them: 4 % more
  check_dealt(graph, across_rows, across_rows, true);
  graph.work[7] = 1.1, graph.work[10] = 0.9;  // 6 % more
  check_dealt(graph, across_rows, both_rows, false);
}

TEST_CASE("a map that is hardly better is not taken", "[ranks]") {
  // Of 100 pairs across 2 % fewer, and 4 % fewer.
  const TileMap first = {0, 1, 1}, other = {0, 0, 1};
  CHECK(!scree::is_better({{1, 0, 1}, {{0, 1, 100}, {1, 2, 98}}}, other, first, 2));
  CHECK(scree::is_better({{1, 0, 1}, {{0, 1, 100}, {1, 2, 96}}}, other, first, 2));
}

TEST_CASE("more pairs across are taken for much less work of the busiest rank", "[ranks]") {
  // A tile with a third of the work, in the middle: 5 and 10.
  const TileGraph graph{{1, 1, 1, 1, 1, 5, 1, 1, 1, 1, 1}, {{4, 5, 10}, {5, 6, 100}}};
  const TileMap even = {0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 1};
  check_dealt(graph, even, even, true);
  check_dealt(graph, {}, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}, false);
}

TEST_CASE("a partitioner is given the same graph for any owners before", "[ranks]") {
  TileGraph graph = two_rows();
  graph.work[3] = 1.5;
  for (const unsigned ranks : {2u, 3u, 4u}) {
    TileGraph given;
    dealt(ranks, graph, [&](const TileGraph& all) {
      given = all;
      return TileMap();
    });
    CHECK(given.work == graph.work);
    REQUIRE(given.edges.size() == graph.edges.size());
    for (std::size_t k = 0; k < given.edges.size(); ++k) {
      CHECK(given.edges[k].tile == graph.edges[k].tile);
      CHECK(given.edges[k].other == graph.edges[k].other);
      CHECK(given.edges[k].pairs == graph.edges[k].pairs);
    }
  }
}

TEST_CASE("a partitioner is not asked about one rank, one or two tiles a rank, or bodies without pairs",
          "[ranks]") {
  bool asked = false;
  const auto notice = [&](const TileGraph&) {
    asked = true;
    return across_rows;
  };
  for (const unsigned ranks : {1u, 5u}) dealt(ranks, two_rows(), notice);
  dealt(4, {two_rows().work, {}}, notice);
  CHECK(!asked);
  dealt(4, two_rows(), notice);
  CHECK(asked);
}

TEST_CASE("ranks are numbered in the order of their tiles", "[ranks]") {
  CHECK(scree::in_order_of_tiles({2, 2, 0, 2, 0, 1, 1}, 3) == TileMap{0, 0, 1, 0, 1, 2, 2});
  CHECK(scree::in_order_of_tiles({}, 3).empty());
  CHECK(scree::in_order_of_tiles({1, 1, 0, 0, 0, 1, 1, 1}, 2) == TileMap{1, 1, 0, 0, 0, 1, 1, 1});
}
