#pragma once

#include <algorithm>
#include <vector>

namespace scree::signals {

// Of one or more values; of an even number the higher of the two in the middle.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace scree::signals
