#include "packing_support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include <scree/packing/overlap.hpp>

using namespace scree::packing;
using scree::Vec3;

namespace {

// Brute force over every pair and every image within one period.
double deepest_by_brute_force(const Packing& packing) {
  double deepest = 0.0;
  std::array<int, 3> images{};
  for (int k = 0; k < packing.dimension; ++k) images[k] = packing.periodic[k] ? 1 : 0;
  for (std::size_t i = 0; i < packing.bodies.size(); ++i) {
    for (std::size_t j = i; j < packing.bodies.size(); ++j) {
      for (int a = -images[0]; a <= images[0]; ++a) {
        for (int b = -images[1]; b <= images[1]; ++b) {
          for (int c = -images[2]; c <= images[2]; ++c) {
            if (i == j && a == 0 && b == 0 && c == 0) continue;
            Vec3 d = packing.bodies[j].position - packing.bodies[i].position;
            if (packing.bounds) {
              const Vec3 length = packing.bounds->upper - packing.bounds->lower;
              d += Vec3{{a * length[0], b * length[1], c * length[2]}};
            }
            deepest = std::max(deepest, packing.bodies[i].radius + packing.bodies[j].radius - norm(d));
          }
        }
      }
    }
  }
  return deepest;
}

}  // namespace

TEST_CASE("two bodies overlap by the sum of their radii minus their distance", "[packing]") {
  const auto overlap = find_overlap(two(1.75));
  REQUIRE(overlap);
  CHECK(overlap->first == 3);
  CHECK(overlap->second == 8);
  CHECK(overlap->depth == 0.25);
  CHECK_FALSE(find_overlap(two(2.0)));
  CHECK_FALSE(find_overlap(two(1.75), 0.25));
  CHECK(find_overlap(two(0.0))->depth == 2.0);
}

TEST_CASE("periodic images count, a body's own included", "[packing]") {
  Packing packing = two(9.0);
  packing.bounds = Bounds{{{0.0, 0.0, 0.0}}, {{10.0, 5.0, 5.0}}};
  CHECK_FALSE(find_overlap(packing));
  packing.periodic = {true, false, false};
  REQUIRE(find_overlap(packing));
  CHECK(find_overlap(packing)->depth == 1.0);
  packing = two(5.0);
  packing.bounds = Bounds{{{0.0, 0.0, 0.0}}, {{10.0, 1.5, 5.0}}};
  packing.periodic = {false, true, false};
  REQUIRE(find_overlap(packing));
  CHECK(find_overlap(packing)->first == find_overlap(packing)->second);
  CHECK(find_overlap(packing)->depth == 0.5);
}

TEST_CASE("the search finds the same deepest overlap as all pairs do", "[packing]") {
  const int dimension = GENERATE(2, 3);
  const bool x = GENERATE(false, true);
  const bool y = GENERATE(false, true);
  const double largest = GENERATE(0.003, 0.02, 0.3);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Packing packing = scattered(dimension, {x, y, x && dimension == 3}, 0.003, largest, seed);
    const double expected = deepest_by_brute_force(packing);
    const auto found = find_overlap(packing);
    REQUIRE(found.has_value() == (expected > 0.0));
    // Both subtract lengths below 5 m; the images are formed in different orders.
    if (found) REQUIRE(std::abs(found->depth - expected) < 8.0 * 5.0 * 2.3e-16);
  }
}

TEST_CASE("the search ends far from the origin and with coincident bodies", "[packing]") {
  Packing packing = two(1e300);
  CHECK_FALSE(find_overlap(packing));
  packing = two(0.0);
  packing.bodies.resize(20'000, packing.bodies[0]);
  for (std::size_t k = 0; k < packing.bodies.size(); ++k) packing.bodies[k].id = std::int64_t(k) + 1;
  CHECK(find_overlap(packing)->depth == 2.0);
}
