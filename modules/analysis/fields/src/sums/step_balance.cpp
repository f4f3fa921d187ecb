#include <scree/fields/step_balance.hpp>

namespace scree::fields {

namespace {

// The sum over the substeps of one step.
Balance momentum_over_substeps(Simulation& simulation, const FieldInput& present, const FieldGrid& grid,
                               const AveragingKernel& kernel, ThreadPool& threads) {
  Balance sum;
  FieldInput before = present;
  simulation.step([&](double length) {
    FieldInput after = input_after_step(simulation, {&before, 1}, length);
    sum.add(momentum_balance(before, after, verlet_shares(before, after, length), grid, kernel, threads));
    before = std::move(after);
  });
  return sum;
}

constexpr int steps_of_predictor_corrector = 6;

std::vector<ForceShare> shares_of(Integration integration, std::span<const FieldInput> inputs, double step) {
  const FieldInput& after = inputs.back();
  switch (integration) {
    case Integration::position_verlet:
      return {{&after, step}};
    case Integration::predictor_corrector:
      return adams_moulton_shares(inputs, step);
    default:
      return verlet_shares(inputs[inputs.size() - 2], after, step);
  }
}

}  // namespace

StepBalances balances_over_step(Simulation& simulation, const FieldInput& present, const FieldGrid& grid,
                                const AveragingKernel& kernel, ThreadPool& threads) {
  const Integration integration = simulation.scene().integration;
  StepBalances balances;
  balances.length = simulation.step_length();
  if (integration == Integration::fourth_order) {
    balances.momentum = momentum_over_substeps(simulation, present, grid, kernel, threads);
    balances.mass = mass_balance(present, input_of(simulation), grid, kernel, threads);
    return balances;
  }
  if (integration == Integration::predictor_corrector) balances.steps = steps_of_predictor_corrector;
  std::vector<FieldInput> inputs = {present};
  for (int k = 0; k < balances.steps; ++k) {
    simulation.step();
    inputs.push_back(input_after_step(simulation, inputs));
  }
  const FieldInput &before = inputs[inputs.size() - 2], &after = inputs.back();
  balances.mass = mass_balance(before, after, grid, kernel, threads);
  balances.momentum =
      momentum_balance(before, after, shares_of(integration, inputs, balances.length), grid, kernel, threads);
  return balances;
}

}  // namespace scree::fields
