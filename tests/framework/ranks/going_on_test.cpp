#include "over_ranks.hpp"
#include "sanitized.hpp"
#include "state/heap.hpp"
#include "step/sliding_layers.hpp"

#include <catch2/catch.hpp>

#include <scree/branching.hpp>
#include <scree/simulation.hpp>

// States that move between numbers of ranks, and what changes a simulation between two steps.

using scree::Integration;
using scree::Ranks;
using scree::Scene;
using scree::Simulation;
using scree::State;
using scree::test::check_same;
using scree::test::integrators;
using scree::test::over_ranks;
using scree::test::sliding_layers;

namespace {

constexpr int steps_of_leg = scree::test::sanitized ? 6 : 40;

State run_on(Simulation& s) {
  s.run(steps_of_leg, [] { return true; });
  return s.state();
}

// The state after some steps of a simulation on so many ranks; 0: in one process without ranks.
State state_after(unsigned ranks, const std::function<State(Ranks*)>& work) {
  if (ranks == 0) return work(nullptr);
  State state;
  over_ranks(ranks, true, [&](Ranks& all) { state = work(&all); });
  return state;
}

State started(unsigned ranks, const Scene& scene) {
  return state_after(ranks, [&](Ranks* all) {
    Simulation s(scene, all);
    return run_on(s);
  });
}

State resumed(unsigned ranks, const Scene& scene, const State& from) {
  return state_after(ranks, [&](Ranks* all) {
    Simulation s(scene, from, all);
    return run_on(s);
  });
}

scree::Parameters changed(const scree::Parameters& parameters, const char* key, std::vector<double> value) {
  scree::Parameters other = parameters;
  other.set(key, std::move(value));
  return other;
}

}  // namespace

TEST_CASE("a run goes on on another number of ranks, and back, to the same bits", "[ranks]") {
  for (const int dimension : {2, 3})
    for (const Integration integration : integrators) {
      if (scree::test::sanitized && integration != Integration::position_verlet) continue;
      INFO("integrator " << int(integration) << ", " << dimension << "D");
      Scene scene = sliding_layers(dimension);
      scene.integration = integration;
      const State first = started(0, scene), second = resumed(0, scene, first),
                  third = resumed(0, scene, second);
      check_same(started(3, scene), first);
      check_same(resumed(2, scene, first), second);
      check_same(resumed(3, scene, second), third);
    }
}

TEST_CASE("a state that is taken over by ranks and saved at once is as it was", "[ranks]") {
  for (const Integration integration : integrators) {
    Scene scene = sliding_layers(3);
    scene.integration = integration;
    const State before = started(0, scene);
    over_ranks(3, true, [&](Ranks& all) { check_same(Simulation(scene, before, &all).state(), before); });
  }
}

TEST_CASE("a scene begins from the state of another over ranks as in one process", "[ranks]") {
  const Scene scene = sliding_layers(3);
  const State before = started(0, scene);
  Scene next = scene;
  next.bodies = scree::present_bodies(before);
  next.laws[0].parameters = changed(next.laws[0].parameters, "static_friction", {0.1});
  const auto begun = [&](Ranks* all) {
    Simulation s(next, before, scree::Branching(), all);
    return run_on(s);
  };
  check_same(state_after(3, begun), begun(nullptr));
}

TEST_CASE("laws, walls and body forces change over ranks as in one process", "[ranks]") {
  enum { massless = 6 };  // of `control`
  for (const Integration integration : {Integration::velocity_verlet, Integration::position_verlet}) {
    Scene scene = sliding_layers(2);
    scene.integration = integration;
    const auto in_stages = [&](Ranks* all) {
      Simulation s(scene, all);
      run_on(s);
      s.reconfigure_law("linear_spring_dashpot", changed(scene.laws[0].parameters, "static_friction", {0.6}));
      scree::Parameters high = scene.boundaries.back().parameters;
      high.set("control", {massless});
      high.set("force", {0, 40});
      high.set("speed_limit", {2});
      s.reconfigure_boundary("high", high);
      s.reconfigure_body_force("gravity",
                               changed(scene.body_forces[0].parameters, "acceleration", {0, -0.3, 0}));
      s.apply_reconfiguration();
      return run_on(s);
    };
    check_same(state_after(3, in_stages), in_stages(nullptr));
  }
}

TEST_CASE("what is refused on all ranks leaves the simulation as it was", "[ranks]") {
  const Scene scene = sliding_layers(2);
  const auto with_refusals = [&](Ranks* all) {
    Simulation s(scene, all);
    CHECK_THROWS_AS(s.reconfigure_law("another", scene.laws[0].parameters), scree::Error);
    CHECK_THROWS_AS(s.reconfigure_boundary("another", scene.boundaries[0].parameters), scree::Error);
    return run_on(s);
  };
  check_same(state_after(2, with_refusals), started(0, scene));
}

TEST_CASE("numbers that observers read are the same over ranks, between steps and substeps", "[ranks]") {
  for (const Integration integration : {Integration::velocity_verlet, Integration::fourth_order}) {
    Scene scene = sliding_layers(3);
    scene.integration = integration;
    const auto observed = [&](Ranks* all) {
      Simulation s(scene, all);
      std::vector<double> numbers;
      const auto look = [&](double) {
        const scree_energy e = s.energy();
        numbers.insert(numbers.end(), {e.kinetic_translation, e.kinetic_rotation, e.residual});
        const scree::ContactList list = s.contact_list();
        numbers.push_back(double(list.size()));
        for (const double overlap : list.overlap) numbers.push_back(overlap);
        for (std::size_t i = 0; i < s.particles().size(); i += 97)
          numbers.push_back(s.particles().position()[1][i]);
      };
      for (int k = 0; k < 3; ++k) {
        s.step(look);
        s.step();
        look(0);
      }
      const scree::Footprint print = s.footprint();
      numbers.insert(numbers.end(), {double(print.listed_pairs), print.crossing_share, s.energy_residual(),
                                     s.momentum_residual(), s.max_overlap_ratio()});
      numbers.push_back(double(s.state_hash() >> 12));
      return numbers;
    };
    const std::vector<double> alone = observed(nullptr);
    std::vector<double> over;
    over_ranks(3, false, [&](Ranks& all) { over = observed(&all); });
    CHECK(over == alone);
  }
}
