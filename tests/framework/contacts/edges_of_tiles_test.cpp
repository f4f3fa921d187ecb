#include "contacts/contacts.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>

#include <catch2/catch.hpp>

using scree::BodyTiles;
using scree::Contacts;
using scree::NeighbourPair;
using scree::TileGraph;

TEST_CASE("pairs between tiles are counted for each two tiles, over all laws, without planes") {
  const BodyTiles tiles(4 * BodyTiles::usual_size + 100);
  std::mt19937 random(1);
  std::set<std::pair<std::uint32_t, std::uint32_t>> listed;
  while (listed.size() < 3000) {
    const auto one = std::uint32_t(random() % tiles.size());
    const auto other = std::min(std::uint32_t(tiles.size() - 1), one + 1 + std::uint32_t(random() % 2000));
    if (one < other) listed.emplace(one, other);
  }
  std::vector<NeighbourPair> pairs;
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> expected;
  for (const auto& [one, other] : listed) {
    pairs.push_back({one, other, 0});
    const std::size_t tile = tiles.owner(one), next = tiles.owner(other);
    if (tile != next) ++expected[{tile, next}];
  }
  const std::uint32_t law_of[] = {0, 1, 1, 0}, plane_material[] = {0};
  std::vector<std::uint32_t> materials(tiles.size());
  for (std::uint32_t& material : materials) material = std::uint32_t(random() % 2);
  Contacts contacts({{0, false, 0}, {0, true, 0}, {1, false, 0}, {1, true, 0}}, tiles);
  scree::ThreadPool threads(1);
  contacts.rebuild(pairs, {{0, 0}, {3000, 0}}, {law_of, 2, materials.data(), plane_material}, {}, threads);

  const std::vector<TileGraph::Edge> edges = contacts.edges_of_tiles();
  REQUIRE(edges.size() == expected.size());
  auto next = expected.begin();
  for (const TileGraph::Edge& edge : edges) {
    CHECK(std::pair<std::size_t, std::size_t>(edge.tile, edge.other) == next->first);
    CHECK(edge.pairs == next->second);
    ++next;
  }
}
