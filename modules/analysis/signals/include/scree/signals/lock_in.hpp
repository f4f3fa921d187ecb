#pragma once

#include <span>

#include <scree/plugin/lock_in.hpp>

namespace scree::signals {

// How drift is kept out of the amplitudes.
enum class Detrending {
  polynomial,     // fitted with the lines, as lock_in.hpp of the plug-in headers describes
  period_average  // the mean over one period is subtracted first (period_average.hpp), then the same
};

// The lock-in of a whole record. times: (s) increasing, as many as values. A duration of 0 in the options
// stands for the length of the record. Throws Error.
LockInResult lock_in(std::span<const double> times, std::span<const double> values, LockInOptions options,
                     Detrending detrending = Detrending::polynomial);

}  // namespace scree::signals
