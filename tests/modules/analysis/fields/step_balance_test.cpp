#include "field_scenes.hpp"
#include "numbers.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <scree/fields/field_sums.hpp>
#include <scree/fields/step_balance.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::fields;

namespace {

ThreadPool& one_worker() {
  static ThreadPool pool(1);
  return pool;
}

std::unique_ptr<Simulation> agitated_with(Integration integration, const PackingScene& packing, int steps) {
  Scene scene = scene_of(packing);
  scene.integration = integration;
  auto simulation = std::make_unique<Simulation>(scene);
  run(*simulation, std::uint64_t(steps));
  return simulation;
}

// Round-off as in balance_test.cpp. Gear's forces are taken with weights that add up to 34/24 in magnitude,
// and the five substeps of fourth_order to 2.3 steps.
constexpr double round_off_of_step = 2e-13;

}  // namespace

TEST_CASE("mass and momentum over a step are balanced at every point with every integrator", "[fields]") {
  for (const IntegrationTraits& traits : integrations())
    for (const PackingScene& packing : packing_scenes) {
      CAPTURE(traits.name, packing.name);
      const auto simulation = agitated_with(traits.integration, packing, 150);
      // Three times, in which contacts begin and end.
      for (int k = 0; k < 3; ++k) {
        // As scree fields does with a state; else the first step goes on from the forces of the one before.
        if (packing.damping > 0 || k == 1) simulation->apply_reconfiguration();
        const FieldInput present = input_of(*simulation);
        const StepBalances step = balances_over_step(*simulation, present, grid_over(packing, 1.6),
                                                     AveragingKernel(packing.dimension, 2), one_worker());
        INFO(fmt::format("mass {:g}, momentum {:g}", step.mass.relative(), step.momentum.relative()));
        CHECK(step.momentum.largest_term > 0.01);
        CHECK(step.mass.relative() < round_off_of_step);
        CHECK(step.momentum.relative() < round_off_of_step);
        run(*simulation, 15);
      }
    }
}

TEST_CASE(
    "forces between steps balance with every integrator, although they are those of mid-step or of a prediction",
    "[fields]") {
  const PackingScene& packing = packing_scenes[2];
  for (const IntegrationTraits& traits : integrations()) {
    CAPTURE(traits.name);
    const auto simulation = agitated_with(traits.integration, packing, 150);
    FieldSums sums(grid_over(packing), AveragingKernel(packing.dimension, 2));
    double most = 0;
    for (int k = 0; k < 20; ++k) {
      simulation->step();
      FieldSums present = sums;
      present.add(input_of(*simulation), one_worker());
      most = std::max(most, force_residual(present.means()));
    }
    CHECK(most < 1e-13);
  }
}

// Adams and Moulton's formula of fourth order over the last four evaluations; a step taken with the
// trapezoidal rule instead leaves its error, of third order in the step.
TEST_CASE("the balance of momentum tells the integrators apart", "[fields]") {
  const PackingScene& packing = packing_scenes[0];
  const auto simulation = agitated_with(Integration::predictor_corrector, packing, 150);
  std::vector<FieldInput> inputs = {input_of(*simulation)};
  for (int k = 0; k < 6; ++k) {
    simulation->step();
    inputs.push_back(input_after_step(*simulation, inputs));
  }
  const auto residual = [&](const std::vector<ForceShare>& forces) {
    return momentum_balance(inputs[5], inputs[6], forces, grid_over(packing), AveragingKernel(3, 2),
                            one_worker())
        .relative();
  };
  const double h = simulation->step_length();
  CHECK(residual(adams_moulton_shares(inputs, h)) < round_off_of_step);
  CHECK(residual(verlet_shares(inputs[5], inputs[6], h)) > 1e-9);
}
