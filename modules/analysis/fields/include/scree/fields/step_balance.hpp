#pragma once

#include <scree/fields/balance.hpp>

namespace scree::fields {

struct StepBalances {
  Balance mass, momentum;
  int steps = 1;      // that were taken; the balances are those of the last
  double length = 0;  // (s) of it
};

// Takes steps from `present`, input_of() the simulation with drag evaluated at its present velocities, until
// the forces of the last one are all known: one, with predictor_corrector six, whose step has the forces of
// four evaluations, each at velocities that three others predict. Momentum is that of the integrator, see
// ForceShare.
StepBalances balances_over_step(Simulation& simulation, const FieldInput& present, const FieldGrid& grid,
                                const AveragingKernel& kernel, ThreadPool& threads);

}  // namespace scree::fields
