#pragma once

namespace scree {

// Sums of the energies of body forces in one evaluation.
struct BodySums {
  double potential = 0;                     // (J)
  double dissipation_rate_translation = 0;  // (W)
  double dissipation_rate_rotation = 0;     // (W)
  double work = 0;                          // (J) since the evaluation before

  void transfer(const class StateTransfer& state);
  BodySums& operator+=(const BodySums& other) {
    potential += other.potential;
    dissipation_rate_translation += other.dissipation_rate_translation;
    dissipation_rate_rotation += other.dissipation_rate_rotation;
    work += other.work;
    return *this;
  }
};

}  // namespace scree
