#pragma once

#include <string>
#include <vector>

namespace scree::snapshot {

// Marks of an axis with their labels, all within the range asked for.
struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels;
};

// About `wanted` marks at multiples of 1, 2 or 5 times a power of ten; whole numbers only, if asked.
Ticks linear_ticks(double lower, double upper, int wanted, bool whole_numbers = false);

// Marks of a logarithmic axis: whole decades or, where they are few, also 2 and 5 of each. Range and marks >
// 0.
Ticks logarithmic_ticks(double lower, double upper, int wanted);

// The range with room for marks on both sides: a share of its length, or of the value where all values are
// equal.
struct Range {
  double lower;
  double upper;
};
Range padded(double lower, double upper, double share);

}  // namespace scree::snapshot
