#include "motion/driven.hpp"
#include "over_ranks.hpp"
#include "sanitized.hpp"
#include "state/heap.hpp"
#include "step/sliding_layers.hpp"

#include <catch2/catch.hpp>

#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

// Scenes that several ranks compute, against the same scenes in one process.

using scree::Integration;
using scree::Ranks;
using scree::Scene;
using scree::Simulation;
using scree::State;
using scree::test::check_same;
using scree::test::integrators;
using scree::test::sliding_layers;

namespace {

constexpr int few_steps = scree::test::sanitized ? 10 : 60;

// The state that the first of some ranks has after some steps, of which every tenth is observed.
State after_steps(const Scene& scene, Ranks* ranks, int steps) {
  Simulation s(scene, ranks);
  for (int k = 0; k < steps / 10; ++k) s.run(10, [] { return true; });
  // Of the pairs of each rank; the hash in the state is of all pairs on the first.
  const std::uint64_t hash = s.state_hash();
  const State state = s.state();
  std::uint64_t in_state = 0;
  scree::StateTransfer::restoring_from(state).value("state_hash", "", in_state);
  CHECK(hash == in_state);
  return state;
}

// at_random: tiles are dealt to ranks anew after each search.
State over_ranks(const Scene& scene, unsigned ranks, bool at_random, int steps) {
  State first;
  scree::test::over_ranks(ranks, at_random, [&](Ranks& all) { first = after_steps(scene, &all, steps); });
  return first;
}

}  // namespace

TEST_CASE("any number of ranks computes the same bits as one process", "[ranks]") {
  for (const int dimension : {2, 3})
    for (const Integration integration : integrators) {
      // Checks of memory take ten times as long and see the same accesses with every integrator.
      if (scree::test::sanitized && integration != Integration::predictor_corrector) continue;
      Scene scene = sliding_layers(dimension);
      scene.integration = integration;
      const int steps = integration == Integration::fourth_order ? 40 : 120;
      const State alone = after_steps(scene, nullptr, steps);
      for (const unsigned ranks : {1u, 2u, 3u, 4u}) {
        if (scree::test::sanitized && (ranks == 1 || ranks == 4)) continue;
        const bool at_random = ranks % 2 == 0;
        INFO("integrator " << int(integration) << ", " << dimension << "D, " << ranks << " ranks");
        check_same(over_ranks(scene, ranks, at_random, steps), alone);
      }
    }
}

TEST_CASE("loads that tiles of several ranks exert on a body are added in the order of the tiles",
          "[ranks]") {
  for (const int dimension : {2, 3}) {
    const Scene scene = sliding_layers(dimension, 2);
    const State alone = after_steps(scene, nullptr, few_steps / 2);
    for (const unsigned ranks : {3u, 5u})
      for (const bool at_random : {false, true}) {
        INFO(dimension << "D, " << ranks << " ranks");
        check_same(over_ranks(scene, ranks, at_random, few_steps / 2), alone);
      }
  }
}

TEST_CASE("walls that try displacements move as with one process", "[ranks]") {
  enum { servo = 5, massless = 6 };  // choices of `control`
  for (const int dimension : {2, 3})
    for (const double control : {double(servo), double(massless)}) {
      Scene scene = sliding_layers(dimension);
      auto& high = scene.boundaries.back().parameters;
      high.set("control", {control});
      high.set("force", {0, 40});
      high.set("speed_limit", {2});
      const State alone = after_steps(scene, nullptr, few_steps);
      for (const bool at_random : {false, true}) {
        INFO(dimension << "D, control " << control);
        check_same(over_ranks(scene, 3, at_random, few_steps), alone);
      }
    }
}

TEST_CASE("a scene of one tile is computed by one of several ranks", "[ranks]") {
  Scene scene = sliding_layers(2);
  scene.bodies.resize(900);
  scene.groups.clear();
  const State alone = after_steps(scene, nullptr, few_steps);
  check_same(over_ranks(scene, 3, false, few_steps), alone);
  check_same(over_ranks(scene, 3, true, few_steps), alone);
}
