#include "bodies/body_range.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/spatial_order.hpp>

using scree::Body;
using scree::spatial_order;

TEST_CASE("the spatial order contains each body once and keeps neighbours together") {
  // A lattice of 16³ in random order. Along the curve, cells of 2 x 2 x 2 follow each other: seven of eight
  // steps stay within one, so that the mean distance of neighbours is a few spacings rather than the third of
  // the box of a random order.
  std::vector<Body> bodies;
  for (int i = 0; i < 16 * 16 * 16; ++i)
    bodies.push_back(scree::test::body(i, 0.5, 1, {{double(i % 16), double(i / 16 % 16), double(i / 256)}}));
  std::shuffle(bodies.begin(), bodies.end(), std::mt19937_64(3));
  const std::vector<std::uint32_t> order = spatial_order(bodies, 3);
  std::vector<std::uint32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  double distance = 0;
  for (std::uint32_t i = 0; i < sorted.size(); ++i) REQUIRE(sorted[i] == i);
  for (std::size_t i = 1; i < order.size(); ++i)
    distance += norm(bodies[order[i]].position - bodies[order[i - 1]].position);
  CHECK(distance / double(order.size()) < 2);
}

TEST_CASE("tiles are compact") {
  // 12 x 12 x 36 sites in random order, cut four times across the longest side at a multiple of 1024 bodies.
  // Each cut may divide a layer of at most 12 x 12 sites, which both parts have in their boxes: a tile
  // touches at most three cuts.
  std::vector<Body> bodies;
  for (int i = 0; i < 12 * 12 * 36; ++i)
    bodies.push_back(scree::test::body(i, 0.5, 1, {{double(i % 12), double(i / 12 % 12), double(i / 144)}}));
  std::shuffle(bodies.begin(), bodies.end(), std::mt19937_64(5));
  const std::vector<std::uint32_t> order = spatial_order(bodies, 3);
  const scree::BodyTiles tiles(bodies.size());
  REQUIRE(tiles.count() == 5);
  for (std::size_t t = 0; t < tiles.count(); ++t) {
    double sites = 1;
    for (int k = 0; k < 3; ++k) {
      double low = 36, high = 0;
      for (std::size_t place = tiles[t].begin; place < tiles[t].end; ++place) {
        low = std::min(low, bodies[order[place]].position[k]);
        high = std::max(high, bodies[order[place]].position[k]);
      }
      sites *= high - low + 1;
    }
    CHECK(sites < double(tiles[t].end - tiles[t].begin) + 3 * 144);
  }
}

TEST_CASE("distant bodies and an empty scene have an order") {
  CHECK(spatial_order(std::vector<Body>(), 3).empty());
  const std::vector<Body> bodies = {scree::test::body(1, 1, 1, {{1e300, 0, 0}}),
                                    scree::test::body(2, 1, 1, {{-1e300, 0, 0}}),
                                    scree::test::body(3, 1, 1, {{0, 0, 0}})};
  CHECK(spatial_order(bodies, 3).size() == 3);
}
