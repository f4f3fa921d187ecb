#pragma once

#include <cstddef>
#include <span>

#include <scree/cycles/classification.hpp>

namespace scree::cycles {

// The laws that fit a strain best, of each kind.
struct SlowingDown {
  Slowing with_limit, without_limit, with_line;
  double preference = 0;  // for a limit: criterion of the law without one minus that of the law with one
  // Whether a straight line after a settling part fits better than both and keeps its slope. The line has 32
  // values and a third of all or more, and a slope above the round-off. straight_from: its first value.
  bool straight = false;
  std::size_t straight_from = 0;
};

// Fits all laws to values at k = 0, 1, ... Autocorrelated values are prewhitened. preference: difference of
// criteria from which the line is preferred.
SlowingDown slowing_down(std::span<const double> values, double round_off, double preference);

}  // namespace scree::cycles
