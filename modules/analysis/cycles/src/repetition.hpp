#pragma once

#include <cstddef>
#include <span>

namespace scree::cycles {

// The period with which values repeat best.
struct Repetition {
  std::size_t period = 0;   // (cycles)
  double f = 0;             // variance between the means of the phases over the variance within phases
  double probability = 1;   // of this or a larger F for values in random order, for any of the periods
  std::size_t periods = 0;  // number tried: 2 to a third of the values, at most 1000
};

// Folds ranks at each period and compares phases with an F test. Ranks resist single large values, and smooth
// curves give a small F, unlike an autocorrelation. For autocorrelated noise the test is repeated on
// prewhitened ranks (each rank less a share of the one before: the correlation of neighbours among deviations
// from the phases), and the smaller F counts. Does not separate repetition from narrow-band noise.
Repetition best_repetition(std::span<const double> values);

}  // namespace scree::cycles
