#include "close_pairs.hpp"

#include "packing_support.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::packing;
using scree::Vec3;

namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// All pairs at the distance of their nearest images.
Pairs by_brute_force(const Packing& packing) {
  Pairs pairs;
  for (std::size_t j = 0; j < packing.bodies.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const Body &a = packing.bodies[i], &b = packing.bodies[j];
      Vec3 apart = a.position - b.position;
      for (int k = 0; k < packing.dimension; ++k) {
        const double length = packing.bounds->upper[k] - packing.bounds->lower[k];
        if (packing.periodic[k]) apart[k] = std::remainder(apart[k], length);
      }
      if (norm(apart) < a.radius + b.radius) pairs.emplace_back(i, j);
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

TEST_CASE("every overlapping pair is visited once", "[packing]") {
  const int dimension = GENERATE(2, 3);
  const bool periodic = GENERATE(false, true);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Packing packing = scattered(dimension, {periodic, periodic, false}, 0.01, 0.3, seed);
    Pairs found;
    visit_close_pairs(packing, [&](const ClosePair& pair) {
      found.push_back(std::minmax(pair.first, pair.second));
      return true;
    });
    std::sort(found.begin(), found.end());
    CHECK(found.size() > 100);
    CHECK(found == by_brute_force(packing));
  }
}

TEST_CASE("a search for pairs ends when its visitor says so", "[packing]") {
  int visited = 0;
  visit_close_pairs(scattered(2, {}, 0.1, 0.3, 1), [&](const ClosePair&) { return ++visited < 7; });
  CHECK(visited == 7);
}
