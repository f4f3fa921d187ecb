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
// equal distances on both sides. The first follows steps and decays, the second slopes and curves; the smaller deviation counts. The first value and the last are
// compared with the median of the five next to them, and must differ from it by thrice the range of these more.
// A deviation must exceed `round_off` and `factor` robust standard deviations of the second kind, from the upper quartile of their absolute values: their median
// would make the tops of smooth curves outliers. An outlier spoils means around it too, so that not a quarter of the values but an eighth may stand off.
// The largest is found first and replaced by that mean or median, so that those around it are not taken for outliers too.
// Not seen: two outliers at an end, and more than five in a row; of three or more in a row on a slope neighbours may be named too.
Outliers find_outliers(std::span<const double> series, double factor, double round_off);

}  // namespace scree::cycles
