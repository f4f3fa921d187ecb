#pragma once

#include "scree/signals/lock_in.hpp"

#include <vector>

namespace scree::signals {

// Largest number of columns: 4 of drift, 6 of harmonics, 20 + 8 + 8 beside them.
inline constexpr std::size_t most_columns = 46;

// Offsets (1/duration) beside harmonic h at which noise is measured, each on both sides; fewer for a short record.
std::vector<int> noise_offsets(const LockInOptions& options, int harmonic);

// Columns of drift and of sines and cosines of the harmonics.
std::size_t model_columns(const LockInOptions& options);
// The same with those beside the harmonics.
std::size_t all_columns(const LockInOptions& options);

// Values of all columns at a time after the start (s).
void fill_columns(const LockInOptions& options, double since_start, double* column);

// Throws Error unless the options are in range.
void check(const LockInOptions& options);

}  // namespace scree::signals
