#pragma once

#include <span>

namespace scree::cycles {

// γ_n = intercept + slope n.
struct StraightLine {
  double intercept = 0;    // γ at n = 0
  double slope = 0;        // per cycle
  double slope_error = 0;  // standard error, for deviations that are independent
  double rms = 0;          // root mean square of the deviations

  // The verdict of McNamara et al. 2008, section IV B 1: the deviations are smaller than the strain of one
  // cycle.
  bool ratchets() const { return rms < (slope < 0 ? -slope : slope); }
};

// The line of least squares through values at n = first, first + 1, ... . Throws Error for fewer than three
// values.
StraightLine fit_line(std::span<const double> values, double first = 0);

// The median of the slopes between all pairs of values (Theil and Sen), or of every s-th distance where there
// are more than four million, and the median of the intercepts. Outliers among up to 29 % of the values leave
// it near the others. slope_error is half the interval of Sen (1968, doi:10.1080/01621459.1968.10480934) for
// one standard deviation.
StraightLine robust_line(std::span<const double> values, double first = 0);

}  // namespace scree::cycles
