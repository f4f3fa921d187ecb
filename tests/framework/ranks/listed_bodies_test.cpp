#include "over_ranks.hpp"
#include "sanitized.hpp"
#include "step/sliding_layers.hpp"

#include <cstdint>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/simulation.hpp>

// Bodies that probes read, where all others may be seen as they were before.

using scree::Particles;
using scree::Ranks;
using scree::Scene;
using scree::Simulation;
using scree::test::over_ranks;
using scree::test::sliding_layers;

namespace {

constexpr int steps_between = scree::test::sanitized ? 6 : 40;
// Of several tiles; the second list is read twice.
const std::vector<std::vector<std::uint32_t>> lists = {{3, 900, 1500, 2100}, {0, 1700}, {0, 1700}, {}};

// What is to be as it is now: state and constants of some bodies.
std::vector<double> numbers_of(const Particles& p, const std::vector<std::uint32_t>& bodies) {
  std::vector<double> numbers;
  for (const std::uint32_t i : bodies) {
    for (const auto& vectors : {p.position(), p.velocity(), p.spin(), p.force(), p.torque()})
      for (int k = 0; k < p.dimension(); ++k)
        if (vectors[k].data()) numbers.push_back(vectors[k][i]);
    for (int k = 0; k < p.orientations.components(); ++k) numbers.push_back(p.orientations[k][i]);
    for (int k = 0; k < p.dimension(); ++k) numbers.push_back(p.image[k][i]);
  }
  for (std::size_t i = 0; i < p.size(); ++i)
    numbers.insert(numbers.end(), {p.radius()[i], p.mass[i], double(p.id[i])});
  return numbers;
}

// of_list: reads the listed bodies alone.
std::vector<std::vector<double>> read_in_a_run(const Scene& scene, Ranks* ranks, bool of_list) {
  Simulation s(scene, ranks);
  std::vector<std::vector<double>> read;
  for (const std::vector<std::uint32_t>& list : lists) {
    s.run(steps_between, [] { return true; });
    read.push_back(numbers_of(of_list ? s.particles(list) : s.particles(), list));
  }
  return read;
}

}  // namespace

TEST_CASE("listed bodies are as they are now, on any number of ranks", "[ranks]") {
  for (const int dimension : {2, 3}) {
    const Scene scene = sliding_layers(dimension);
    const auto expected = read_in_a_run(scene, nullptr, false);
    CHECK(read_in_a_run(scene, nullptr, true) == expected);
    for (const bool at_random : {false, true})
      over_ranks(3, at_random, [&](Ranks& ranks) {
        INFO(dimension << "D, tiles at random " << at_random);
        CHECK(read_in_a_run(scene, &ranks, true) == expected);
      });
  }
}

TEST_CASE("after listed bodies, all bodies are as they are now", "[ranks]") {
  const Scene scene = sliding_layers(3);
  const auto all_positions = [&](Ranks* ranks) {
    Simulation s(scene, ranks);
    s.run(steps_between, [] { return true; });
    s.particles({4, 1500});
    std::vector<std::uint32_t> all(scene.bodies.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    return numbers_of(s.particles(), all);
  };
  const std::vector<double> expected = all_positions(nullptr);
  over_ranks(2, true, [&](Ranks& ranks) { CHECK(all_positions(&ranks) == expected); });
}
