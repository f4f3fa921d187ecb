#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace scree::cycles {

// Values that stand off from those around them.
struct Outliers {
  std::vector<std::size_t> places;  // in the series
  double deviation = 0;  // robust standard deviation of the values from the means of values beside them
  double threshold = 0;  // that the deviations of `places` exceed
  double largest = 0;    // deviation of an outlier
};

// The value in a place is compared with the median of up to five on each side and itself, and with the median of the means of the pairs at
// equal distances on both sides. The first follows steps and decays, the second slopes and curves; the smaller deviation counts. It must exceed
// `factor` robust standard deviations (from the upper quartile of the absolute deviations, so that
// outliers are a minority of a quarter) of the second, and `round_off`.
// The largest is found first and replaced by that mean, so that those around it are not taken for outliers too.
// Not seen: the first and the last value, and more than five outliers in a row; of three or more in a row on a slope neighbours may be named too.
Outliers find_outliers(std::span<const double> series, double factor, double round_off);

}  // namespace scree::cycles
