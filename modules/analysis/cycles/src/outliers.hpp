#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace scree::cycles {

// Values that stand off from those around them.
struct Outliers {
  std::vector<std::size_t> places;  // indices in the series
  double deviation = 0;  // robust standard deviation of the values from the means of their neighbours
  double threshold = 0;  // which the deviations of all outliers exceed
  double largest = 0;    // largest deviation of an outlier
};

// Compares each value with the median of itself and up to five on each side, which follows steps and decays,
// and with the median of the means of pairs at equal distances on both sides, which follows slopes and
// curves. The smaller deviation counts. The first and the last value are compared with the median of the five
// next to them, and must differ from it by three times the range of these more. An outlier deviates by more
// than `round_off` and by more than `factor` robust standard deviations. These come from the upper quartile
// of the deviations from pairs: their median would make the tops of smooth curves outliers. An outlier also
// spoils means around it, so that only an eighth of the values may stand off, not a quarter. The largest
// outlier is found first and replaced by its mean or median, so that its neighbours do not count as outliers
// too. Not found: two outliers at an end, and more than five in a row. Of three or more in a row on a slope
// neighbours may be named as well.
Outliers find_outliers(std::span<const double> series, double factor, double round_off);

}  // namespace scree::cycles
