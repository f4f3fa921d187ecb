#pragma once

#include <cstddef>
#include <span>

#include <scree/cycles/classification.hpp>

namespace scree::cycles {

// The laws that fit a strain best.
struct SlowingDown {
  Slowing with_limit, without_limit, with_line;
  double preference = 0;  // for a limit: criterion without one less that with one
  // Whether a straight line behind a settling part fits better than both, and keeps its slope; and its first value. It has 32 values and a
  // third of all, or more, and a slope above the round-off.
  bool straight = false;
  std::size_t straight_from = 0;
};

// Of values at k = 0, 1, ... Values that remember the one before are fitted by what is new in each. preference: by which criteria of
// laws differ where the line is preferred.
SlowingDown slowing_down(std::span<const double> values, double round_off, double preference);

}  // namespace scree::cycles
