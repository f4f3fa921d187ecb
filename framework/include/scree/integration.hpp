#pragma once

#include <span>

namespace scree {

// Time integration schemes.
enum class Integration { velocity_verlet, position_verlet, fourth_order, predictor_corrector };

// Properties of a scheme, for choosing one.
struct IntegrationTraits {
  Integration integration;
  const char* name;     // as in a scenario: time.integrator
  const char* summary;  // one line: scheme, order, and how damping and contact onset change the order
  int evaluations;      // force evaluations per step
  // Longest stable step over the one of velocity Verlet, which for an oscillator with angular frequency ω
  // and damping rate η is 2/(√(4η² + ω²) + 2η).
  double stable_step;
};
std::span<const IntegrationTraits> integrations();  // all schemes, in the order of the enumeration
const IntegrationTraits& traits_of(Integration integration);

}  // namespace scree
