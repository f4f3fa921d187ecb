#pragma once

#include <span>

namespace scree {

// How bodies move from one evaluation of the forces to the next.
enum class Integration { velocity_verlet, position_verlet, fourth_order, predictor_corrector };

// What to know before choosing.
struct IntegrationTraits {
  Integration integration;
  const char* name;     // as in a scenario
  const char* summary;  // one line: scheme, order, what damping and contact onset do to it
  int evaluations;      // of the forces in a step
  // The longest stable step as a share of velocity Verlet's, which for an oscillator with frequency ω and
  // damping rate η is 2/(√(4η² + ω²) + 2η).
  double stable_step;
};
std::span<const IntegrationTraits> integrations();
const IntegrationTraits& traits_of(Integration integration);

}  // namespace scree
