#pragma once

#include <cstddef>
#include <span>

namespace scree::cycles {

// Whether the strain per cycle falls with the cycle: increments between means of consecutive blocks of cycles. Those of single cycles are hidden by a noise above the
// strain per cycle, from which means over longer blocks stand out.
struct Settling {
  double correlation = 0;      // rank correlation of |increment| with its place
  double probability = 1;      // of this or a lower one in noise, for any of the lengths of blocks
  std::size_t block = 0;       // (cycles) with the lowest probability
  std::size_t increments = 0;  // between blocks of this length
  std::size_t lengths = 0;     // that were tried: 1, 2, 4, ... while there are eight blocks or more
};

Settling settling_of(std::span<const double> values);

}  // namespace scree::cycles
