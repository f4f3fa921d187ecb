#pragma once

#include <cstddef>
#include <span>

namespace scree::cycles {

// The period with which values repeat best.
struct Repetition {
  std::size_t period = 0;   // (cycles)
  double f = 0;             // variance of the means of the phases over that within phases
  double probability = 1;   // of this or a larger F in values in random order, for any of the periods
  std::size_t periods = 0;  // that were tried: 2 to a third of the values, at most 1000
};

// The values are folded at each period and their ranks compared between phases. Unlike an autocorrelation, this is small for smooth curves, and ranks
// keep two large values from passing for a repetition. Values that remember the one before, as in a random walk, differ between phases more than independent
// ones; F is therefore the smaller of that of the ranks and that of what is new in each: its rank less a part of the one before. This part is the correlation of neighbours
// among deviations from the phases, so that of a repetition under independent noise there is none. Noise with a frequency of its own is not told from a repetition.
Repetition best_repetition(std::span<const double> values);

}  // namespace scree::cycles
