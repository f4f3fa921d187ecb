#pragma once

#include <cstddef>
#include <span>

namespace scree::cycles {

// Whether the strain per cycle falls with the cycle: the increments between means of consecutive blocks of
// cycles. Noise above the strain per cycle hides the increments of single cycles, not those of longer blocks.
struct Settling {
  double correlation = 0;      // rank correlation of |increment| with its place
  double probability = 1;      // of this or a lower correlation in noise, for any of the lengths tried
  std::size_t block = 0;       // (cycles) length with the lowest probability
  std::size_t increments = 0;  // between blocks of this length
  std::size_t lengths = 0;     // number tried: 1, 2, 4, ... cycles while there are eight blocks or more
};

Settling settling_of(std::span<const double> values);

}  // namespace scree::cycles
