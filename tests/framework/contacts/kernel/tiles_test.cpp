#include "sanitized.hpp"
#include "scenes.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

// Scenes large enough to be cut into several tiles: loads that cross from one tile to another.

using scree::Body;
using scree::ContactList;
using scree::Scene;
using scree::Simulation;
using scree::Vec3;

namespace {

// A perturbed lattice between two walls and periodic faces; each body touches its neighbours. They are
// numbered at random, so that most pairs cross tiles, or line by line.
Scene crowd(int dimension, int per_axis, unsigned threads, bool at_random = true) {
  const int all = dimension == 2 ? per_axis * per_axis : per_axis * per_axis * per_axis;
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Body> bodies;
  for (int i = 0; i < all; ++i) {
    Vec3 x = {}, v = {}, spin = {};
    for (int k = 0, rest = i; k < dimension; ++k, rest /= per_axis) {
      x[k] = 1 + 1.95 * (rest % per_axis) + 0.02 * uniform(generator);
      v[k] = uniform(generator);
    }
    for (int k = dimension == 2 ? 2 : 0; k < 3; ++k) spin[k] = uniform(generator);
    bodies.push_back(scree::test::body(i, 1, 1, x, v, spin, dimension));
  }
  if (at_random) std::shuffle(bodies.begin(), bodies.end(), generator);
  Scene s = scree::test::scene(dimension, 1e-4, bodies,
                               {{"normal_stiffness", {1e4}},
                                {"normal_damping", {5}},
                                {"tangential_stiffness", {3e3}},
                                {"tangential_damping", {1}},
                                {"static_friction", {0.3}},
                                {"rolling_friction", {0.02}}});
  s.threads = threads;
  s.min_bodies_per_thread = 1;
  const double length = 1.95 * per_axis;
  scree::test::add_boundary(s, "periodic", {{"axes", {0}}, {"lower", {0, 0, 0}}, {"upper", {length, 1, 1}}});
  scree::test::add_boundary(s, "plane", {{"point", {0, 0.02, 0}}, {"normal", {0, 1, 0}}}, "low");
  scree::test::add_boundary(s, "plane", {{"point", {0, length - 0.02, 0}}, {"normal", {0, -1, 0}}}, "high");
  return s;
}

// For three or four tiles.
int per_axis(int dimension) { return dimension == 2 ? 60 : 16; }

}  // namespace

TEST_CASE("scenes of several tiles have the same bits for any number of threads", "[threads]") {
  for (const int dimension : {2, 3}) {
    std::vector<std::uint64_t> hashes;
    for (const unsigned threads : {1u, 2u, 3u, 5u}) {
      Simulation s(crowd(dimension, per_axis(dimension), threads));
      scree::test::run(s, scree::test::fewer_if_sanitized(40));
      hashes.push_back(s.state_hash());
    }
    for (const std::uint64_t hash : hashes) CHECK(hash == hashes[0]);
  }
}

// 16 tiles: two threads finish some tiles while contacts of others are evaluated.
TEST_CASE("scenes of many tiles have the same bits for any number of threads", "[threads]") {
  for (const bool at_random : {false, true}) {
    std::vector<std::uint64_t> hashes;
    for (const unsigned threads : {1u, 2u, 2u, 2u}) {
      Simulation s(crowd(2, 129, threads, at_random));
      scree::test::run(s, scree::test::fewer_if_sanitized(20));
      hashes.push_back(s.state_hash());
    }
    for (const std::uint64_t hash : hashes) CHECK(hash == hashes[0]);
  }
}

TEST_CASE("the loads of all tiles equal the sums over single contacts") {
  for (const int dimension : {2, 3}) {
    Simulation s(crowd(dimension, per_axis(dimension), 2));
    scree::test::run(s, 20);
    const ContactList list = s.contact_list();
    const std::size_t bodies = s.particles().size();
    REQUIRE(list.size() > bodies);
    std::vector<Vec3> expected(bodies + 2);
    double largest = 0;
    for (std::size_t c = 0; c < list.size(); ++c) {
      const Vec3 f = {{list.force[3 * c], list.force[3 * c + 1], list.force[3 * c + 2]}};
      expected[list.a[c]] += f;
      expected[list.b[c]] -= f;
      largest = std::max(largest, norm(f));
    }
    // A dozen forces are added to each body, a few hundred to each wall.
    const double allowed = 1e3 * 2.2e-16 * largest;
    double worst = 0, on_walls = 0;
    for (std::size_t i = 0; i < bodies; ++i)
      for (int k = 0; k < dimension; ++k)
        worst = std::max(worst, std::abs(s.particles().force()[k][i] - expected[i][k]));
    for (std::size_t w = 0; w < 2; ++w)
      for (int k = 0; k < dimension; ++k)
        on_walls = std::max(on_walls, std::abs(s.loads()[w].force[k] - expected[bodies + w][k]));
    CHECK(worst <= allowed);
    CHECK(on_walls <= 1e3 * allowed);
    CHECK(norm(expected[bodies]) > 0);
  }
}
