#include "motion/integrator.hpp"

#include "motion/predictor_corrector.hpp"
#include "motion/verlet.hpp"

namespace scree {

namespace {

// Stable steps from the eigenvalues of one step of a damped oscillator, for damping ratios from 0 to 3;
// verified in tests/framework/motion/integrator_choice_test.cpp.
constexpr IntegrationTraits all_integrations[] = {
    {Integration::velocity_verlet, "velocity_verlet",
     "order 2, symplectic; dashpots, contact onset, sliding and sticking keep order 2", 1, 1},
    {Integration::position_verlet, "position_verlet",
     "order 2, symplectic, forces at mid-step; otherwise as velocity Verlet", 1, 1},
    {Integration::fourth_order, "fourth_order",
     "order 4, symplectic (Suzuki), for elastic motion without friction; dashpots and friction reduce it to 2, "
     "contact onset with a dashpot to 1, since the third substep goes backwards in time",
     5, 1.35},
    {Integration::predictor_corrector, "predictor_corrector",
     "order 4 (Gear) in smooth motion, 2 at the start and through contacts; "
     "not symplectic, elastic motion gains energy",
     1, 0.25},
};

}  // namespace

std::span<const IntegrationTraits> integrations() { return all_integrations; }

const IntegrationTraits& traits_of(Integration integration) {
  return all_integrations[std::size_t(integration)];
}

std::span<const double> Integrator::substeps() const {
  static constexpr double whole[] = {1};
  return whole;
}

Integrator::Moved Integrator::finish_and_begin_step(Particles& particles, double step, double next,
                                                    BodyRange bodies) {
  const bool finite = finish_step(particles, step, bodies);
  return {finite, begin_step(particles, next, bodies)};
}

std::unique_ptr<Integrator> make_integrator(Integration integration) {
  switch (integration) {
    case Integration::position_verlet:
      return std::make_unique<PositionVerlet>();
    case Integration::fourth_order:
      return std::make_unique<FourthOrder>();
    case Integration::predictor_corrector:
      return std::make_unique<PredictorCorrector>();
    case Integration::velocity_verlet:
      break;
  }
  return std::make_unique<VelocityVerlet>();
}

}  // namespace scree
