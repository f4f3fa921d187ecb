#pragma once

#include <cstddef>
#include <span>

namespace scree::cycles {

// Whether the strain per cycle falls with the cycle.
struct Settling {
  double correlation = 0;  // rank correlation of |γ_{n+1} − γ_n| with n
  double probability = 1;  // of this or a lower one in values in random order
  std::size_t pairs = 0;   // of values, each in one pair only, so that noise makes them independent
};

Settling settling_of(std::span<const double> values);

}  // namespace scree::cycles
