#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/pair_search.hpp>

// Lists are compared exactly: a pair whose distance equals its reach within rounding may be listed or not,
// but random coordinates do not produce such pairs, and the constructed scenes avoid them.

using scree::Body;
using scree::Domain;
using scree::NeighbourPair;
using scree::Vec3;

namespace {

using scree::PairSearch;

std::vector<scree::Sphere> spheres_of(const std::vector<Body>& bodies) {
  std::vector<scree::Sphere> spheres;
  for (const Body& body : bodies) spheres.push_back({body.position, body.radius});
  return spheres;
}

std::vector<NeighbourPair> visited(PairSearch::Images images, int dimension, const std::vector<Body>& bodies,
                                   const Domain& domain, double skin) {
  std::vector<NeighbourPair> pairs;
  PairSearch(images).visit(spheres_of(bodies), dimension, domain, skin, [&](const NeighbourPair& pair) {
    pairs.push_back(pair);
    return true;
  });
  std::sort(pairs.begin(), pairs.end(), [](const NeighbourPair& p, const NeighbourPair& q) {
    return std::tie(p.a, p.b) < std::tie(q.a, q.b);
  });
  return pairs;
}

struct Sizes {
  double smallest, largest;
};

// Random bodies; the logarithm of the radius is uniform, so that all levels of the hierarchy are filled.
class Dealer {
 public:
  Dealer(int dimension, unsigned seed) : dimension_(dimension), generator_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  double radius(const Sizes& s) {
    return s.smallest * std::exp(between(0, std::log(s.largest / s.smallest)));
  }
  Vec3 point(double low, double high) {
    Vec3 x = {};
    for (int k = 0; k < dimension_; ++k) x[k] = between(low, high);
    return x;
  }
  std::vector<Body> uniform(std::size_t count, const Sizes& sizes, double low, double high) {
    std::vector<Body> bodies;
    for (std::size_t i = 0; i < count; ++i)
      bodies.push_back(scree::test::body(std::int64_t(i), radius(sizes), 1, point(low, high)));
    return bodies;
  }
  // Clusters of bodies around a few centres, many of them overlapping.
  std::vector<Body> clustered(std::size_t count, const Sizes& sizes, double low, double high) {
    std::vector<Body> bodies;
    const Vec3 centres[] = {point(low, high), point(low, high), point(low, high)};
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 x = centres[i % 3] + point(-0.05 * (high - low), 0.05 * (high - low));
      for (int k = 0; k < dimension_; ++k) x[k] = std::clamp(x[k], low, high);
      bodies.push_back(scree::test::body(std::int64_t(i), radius(sizes), 1, x));
    }
    return bodies;
  }

 private:
  int dimension_;
  std::mt19937_64 generator_;
};

// All neighbours, by testing all pairs and all 27 images.
std::vector<NeighbourPair> brute_force(int dimension, const std::vector<Body>& bodies, const Domain& domain,
                                       double skin) {
  std::vector<NeighbourPair> pairs;
  for (std::uint32_t a = 0; a < bodies.size(); ++a)
    for (std::uint32_t b = a + 1; b < bodies.size(); ++b)
      for (std::uint8_t code = 0; code < 27; ++code) {
        Vec3 d = bodies[a].position - bodies[b].position;
        bool exists = true;
        for (int k = 0, rest = code; k < 3; ++k, rest /= 3) {
          const int turns = rest % 3 - 1;
          exists = exists && (turns == 0 || (k < dimension && domain.periodic[k]));
          d[k] += turns * domain.length(k);
        }
        if (exists && norm(d) < bodies[a].radius + bodies[b].radius + skin) pairs.push_back({a, b, code});
      }
  return pairs;
}

std::size_t check(int dimension, const std::vector<Body>& bodies, const Domain& domain, double skin) {
  const std::vector<NeighbourPair> expected = brute_force(dimension, bodies, domain, skin);
  // brute_force loops over a, then b: equality implies sorted and each pair once.
  scree::ThreadPool threads(2);
  CHECK(PairSearch().find(spheres_of(bodies), dimension, domain, skin, threads) == expected);
  CHECK(visited(PairSearch::Images::unique, dimension, bodies, domain, skin) == expected);
  return expected.size();
}

Domain periodic_along(std::array<bool, 3> axes, double low, double high) {
  return {axes, {{low, low, low}}, {{high, high, high}}};
}

// Edge of a box that contains this number of bodies of this size at a medium density.
double box_edge(int dimension, std::size_t count, double radius) {
  return 2.2 * radius * std::pow(double(count), 1.0 / dimension);
}

}  // namespace

TEST_CASE("neighbours equal those of brute force, for all kinds of packings, sizes and domains") {
  struct Case {
    Sizes sizes;
    std::size_t count;
  };
  const int dimension = GENERATE(2, 3);
  const Case c =
      GENERATE(Case{{1, 1}, 400}, Case{{0.8, 1.2}, 400}, Case{{0.05, 1}, 500}, Case{{0.01, 1}, 600});
  const double skin = GENERATE(1e-9, 0.1, 1.5);
  const bool clustered = GENERATE(false, true);
  CAPTURE(dimension, c.sizes.smallest, skin, clustered);

  // At least twice the longest reach.
  const double half =
      std::max(0.5 * box_edge(dimension, c.count, 0.6 * c.sizes.largest), 2 * c.sizes.largest + skin);
  const double low = -half + 0.3, high = half + 0.3;
  Dealer dealer(dimension, 7u + unsigned(dimension));
  const std::vector<Body> bodies =
      clustered ? dealer.clustered(c.count, c.sizes, low, high) : dealer.uniform(c.count, c.sizes, low, high);
  std::size_t found = 0;
  for (const std::array<bool, 3> axes :
       {std::array{false, false, false}, std::array{true, false, false}, std::array{false, true, false},
        std::array{true, true, dimension == 3}})
    found += check(dimension, bodies, periodic_along(axes, low, high), skin);
  CHECK(found > 0);
}

TEST_CASE("no body and one body have no neighbours") {
  for (const int dimension : {2, 3}) {
    CHECK(check(dimension, {}, {}, 0.1) == 0);
    CHECK(check(dimension, {scree::test::body(0, 1, 1, {{4, 5, 0}})}, {}, 0.1) == 0);
  }
}

TEST_CASE("few bodies in any number of cells, also across a periodic face", "[threads]") {
  for (const int dimension : {2, 3})
    for (unsigned seed = 0; seed < 200; ++seed) {
      Dealer dealer(dimension, seed);
      // From two reaches, the shortest allowed domain, to eight.
      const double edge = dealer.between(4.2, 17), skin = 0.1;
      const std::vector<Body> bodies = dealer.uniform(2 + seed % 9, {0.5, 1}, 0, edge);
      check(dimension, bodies, {}, skin);
      check(dimension, bodies, periodic_along({true, true, dimension == 3}, 0, edge), skin);
    }
}

TEST_CASE("bodies on the faces of a periodic domain are paired with their images") {
  const double edge = 10, inside = 0.4;
  const std::vector<double> coordinates = {0, inside, edge - inside, edge};
  std::vector<Body> bodies;
  for (const double x : coordinates)
    for (const double y : coordinates)
      bodies.push_back(scree::test::body(std::int64_t(bodies.size()), 1, 1, {{x, y, 5}}));
  // All 16 lie around one corner: every pair is a neighbour.
  CHECK(check(2, bodies, periodic_along({true, true, false}, 0, edge), 0.1) == 16 * 15 / 2);
  CHECK(check(3, bodies, periodic_along({true, true, true}, 0, edge), 0.1) == 16 * 15 / 2);
}

TEST_CASE("distant heaps and scattered bodies share cells and still have the right neighbours", "[threads]") {
  const double distance = GENERATE(30.0, 1e3, 1e6, 1e9);
  CAPTURE(distance);
  for (const int dimension : {2, 3}) {
    Dealer dealer(dimension, 11);
    const double edge = box_edge(dimension, 100, 1);
    std::vector<Body> bodies;
    for (const double at : {0.0, distance, -2 * distance}) {
      const std::vector<Body> heap = dealer.uniform(100, {0.3, 1}, at, at + edge);
      bodies.insert(bodies.end(), heap.begin(), heap.end());
    }
    const std::vector<Body> scattered = dealer.uniform(50, {0.3, 1}, -2 * distance, distance);
    bodies.insert(bodies.end(), scattered.begin(), scattered.end());
    CHECK(check(dimension, bodies, {}, 0.1) > 0);
  }
}

TEST_CASE("one very distant body hides no pair") {
  for (const int dimension : {2, 3}) {
    Dealer dealer(dimension, 3);
    std::vector<Body> bodies = dealer.uniform(300, {0.5, 1}, 0, box_edge(dimension, 300, 1));
    const std::size_t without = check(dimension, bodies, {}, 0.1);
    bodies.push_back(scree::test::body(300, 1, 1, {{1e6, -1e6, dimension == 3 ? 1e6 : 0}}));
    CHECK(check(dimension, bodies, {}, 0.1) == without);
    // The same with one far larger than the others.
    bodies.push_back(scree::test::body(301, 1e3, 1, {{-1e3, 0, 0}}));
    CHECK(check(dimension, bodies, {}, 0.1) > without);
  }
}

TEST_CASE("bodies at one point, in a line and in a plane") {
  const std::size_t n = 60;
  std::vector<Body> point, line, sheet;
  for (std::size_t i = 0; i < n; ++i) {
    const auto id = std::int64_t(i);
    point.push_back(scree::test::body(id, 1, 1, {{3, -2, 1}}));
    line.push_back(scree::test::body(id, 1, 1, {{0, 1.9 * double(i), 0}}));
    sheet.push_back(scree::test::body(id, 1, 1, {{1.9 * double(i % 8), 1.9 * double(i / 8), 0}}));
  }
  for (const int dimension : {2, 3}) {
    CHECK(check(dimension, point, {}, 0.1) == n * (n - 1) / 2);
    CHECK(check(dimension, line, {}, 0.05) == n - 1);
    CHECK(check(dimension, line, {}, 0.2) == n - 1);
    CHECK(check(dimension, sheet, {}, 0.05) > n);
  }
}

TEST_CASE("the order of the bodies does not change the neighbours") {
  Dealer dealer(3, 11);
  std::vector<Body> bodies = dealer.uniform(300, {0.05, 1}, 0, 12);
  const std::size_t found = check(3, bodies, {}, 0.1);
  std::reverse(bodies.begin(), bodies.end());
  CHECK(check(3, bodies, {}, 0.1) == found);
}

TEST_CASE("a periodic length under twice the largest reach is refused") {
  const std::vector<Body> bodies = {scree::test::body(0, 1, 1, {{1, 1, 1}}),
                                    scree::test::body(1, 0.5, 1, {{2, 2, 2}})};
  const double skin = 0.25, shortest = 2 * (2 + skin);  // exact in binary
  scree::ThreadPool threads(1);
  const auto find = [&](int dimension, const Domain& domain) {
    PairSearch().find(spheres_of(bodies), dimension, domain, skin, threads);
  };
  for (const int dimension : {2, 3}) {
    CHECK_NOTHROW(find(dimension, periodic_along({true, false, false}, 0, shortest)));
    try {
      find(dimension, periodic_along({false, true, false}, 0, std::nextafter(shortest, 0.0)));
      FAIL("not refused");
    } catch (const scree::Error& error) {
      CHECK(error.status() == scree::ExitStatus::bad_input);
      CHECK_THAT(error.what(), Catch::Contains("along y") && Catch::Contains("4.5 m"));
    }
  }
}

TEST_CASE("in a short period the nearest image of each pair is found") {
  const int dimension = GENERATE(2, 3);
  Dealer dealer(dimension, 11);
  const double high = GENERATE(0.7, 1.9, 3.1, 5.0), skin = 0.1;
  const Domain domain = periodic_along({true, true, dimension == 3}, 0, high);
  const std::vector<Body> bodies = dealer.uniform(60, {0.02, 1}, 0, high);
  std::vector<NeighbourPair> nearest;
  for (const NeighbourPair& pair : brute_force(dimension, bodies, domain, skin)) {
    const auto distance = [&](const NeighbourPair& p) {
      return norm(bodies[p.a].position - bodies[p.b].position + domain.shift(p.image));
    };
    if (nearest.empty() || nearest.back().a != pair.a || nearest.back().b != pair.b)
      nearest.push_back(pair);
    else if (distance(pair) < distance(nearest.back()))
      nearest.back() = pair;
  }
  CHECK(!nearest.empty());
  CHECK(visited(PairSearch::Images::nearest, dimension, bodies, domain, skin) == nearest);
}

TEST_CASE("a visit ends where it is told to") {
  Dealer dealer(3, 2);
  int visits = 0;
  PairSearch().visit(spheres_of(dealer.uniform(50, {1, 1}, 0, 2)), 3, {}, 0.1,
                     [&](const NeighbourPair&) { return ++visits < 7; });
  CHECK(visits == 7);
}
