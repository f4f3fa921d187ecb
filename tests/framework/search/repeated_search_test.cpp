#include "search/repeated_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

using scree::Domain;
using scree::NeighbourPair;
using scree::PairSearch;
using scree::RepeatedSearch;
using scree::Sphere;
using scree::Vec3;

namespace {

constexpr double anywhere = std::numeric_limits<double>::infinity();

// Bodies with constant velocities of the same magnitude, so that many pairs approach each other at twice it.
struct Moving {
  Domain domain;
  int dimension;
  std::vector<Sphere> bodies;
  std::vector<Vec3> velocity;  // of magnitude 1

  Moving(int dimensions, std::size_t count, double smallest, std::array<bool, 3> periodic, double edge)
      : domain{periodic, {}, {{edge, edge, dimensions == 3 ? edge : 1}}}, dimension(dimensions) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> share(0, 1);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < count; ++i) {
      Sphere body = {{}, smallest + (1 - smallest) * std::pow(share(random), 3)};
      Vec3 v = {};
      for (int k = 0; k < dimension; ++k) body.position[k] = edge * share(random), v[k] = normal(random);
      bodies.push_back(body);
      velocity.push_back(1 / norm(v) * v);
    }
  }
  // By a distance (m), and back into the domain.
  void move(double distance) {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (int k = 0; k < dimension; ++k) {
        double& x = bodies[i].position[k];
        x += distance * velocity[i][k];
        if (domain.periodic[k]) x -= std::floor((x - domain.lower[k]) / domain.length(k)) * domain.length(k);
      }
  }
};

}  // namespace

TEST_CASE("repeated searches find the pairs of single ones, in their order and with their images",
          "[threads]") {
  const int dimension = GENERATE(2, 3);
  const double smallest = GENERATE(1.0, 0.1);
  const std::array<bool, 3> periodic =
      GENERATE(std::array{false, false, false}, std::array{true, false, false}, std::array{true, true, true});
  const unsigned number_of_threads = GENERATE(1u, 2u);
  Moving scene(dimension, 3000, smallest, {periodic[0], periodic[1], periodic[2] && dimension == 3},
               dimension == 2 ? 110 : 30);
  scree::ThreadPool threads(number_of_threads);
  RepeatedSearch repeated;
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> change(0.8, 1.25), share(0, 0.5);
  double skin = 0.1, moved = anywhere;
  constexpr std::size_t searches = 60;
  for (std::size_t k = 0; k < searches; ++k) {
    const auto& found = repeated.find(scene.bodies, dimension, scene.domain, skin, moved, threads);
    CHECK(found == PairSearch().find(scene.bodies, dimension, scene.domain, skin, threads));
    CHECK(found.size() > 300);
    moved = share(random) * skin;
    skin = std::clamp(skin * change(random), 0.03, 0.3);
    scene.move(moved);
  }
  CHECK(repeated.grid_searches() < searches / 2);
}

TEST_CASE("a repeated search starts anew if bodies may be anywhere, and after one that failed", "[search]") {
  Moving scene(3, 400, 0.5, {true, true, true}, 14);
  scree::ThreadPool threads(1);
  RepeatedSearch repeated;
  const auto check_anew = [&](double skin, double moved) {
    CHECK(repeated.find(scene.bodies, 3, scene.domain, skin, moved, threads) ==
          PairSearch().find(scene.bodies, 3, scene.domain, skin, threads));
  };
  for (int k = 0; k < 3; ++k) check_anew(0.1, 0);
  std::reverse(scene.bodies.begin(), scene.bodies.end());
  scene.bodies.resize(300);
  check_anew(0.1, anywhere);
  check_anew(0.1, 0);
  CHECK_THROWS_AS(repeated.find(scene.bodies, 3, scene.domain, 6, 0, threads), scree::Error);
  check_anew(0.1, 0);
}

TEST_CASE("a repeated search has no margin where a pair of candidates would have two images", "[search]") {
  // Twice the largest reach is 4.2 m, and with any margin more than the period.
  Moving scene(3, 20, 1, {true, true, true}, 4.25);
  scree::ThreadPool threads(1);
  RepeatedSearch repeated;
  for (std::size_t k = 1; k < 6; ++k) {
    CHECK(repeated.find(scene.bodies, 3, scene.domain, 0.1, 0, threads) ==
          PairSearch().find(scene.bodies, 3, scene.domain, 0.1, threads));
    CHECK(repeated.grid_searches() == k);
  }
}

TEST_CASE("a repeated search has no margin where coordinates are rounded by more", "[search]") {
  Moving scene(3, 400, 0.5, {false, false, false}, 14);
  // By far: 4 mm between two numbers, beside a skin of 0.1 m.
  for (Sphere& body : scene.bodies) body.position[0] += 2e13;
  scree::ThreadPool threads(1);
  RepeatedSearch repeated;
  for (int k = 0; k < 3; ++k)
    CHECK(repeated.find(scene.bodies, 3, scene.domain, 0.1, 0, threads) ==
          PairSearch().find(scene.bodies, 3, scene.domain, 0.1, threads));
}
