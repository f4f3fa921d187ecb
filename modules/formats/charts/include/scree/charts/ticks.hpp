#pragma once

#include <string>
#include <vector>

namespace scree::charts {

// Ticks of an axis with their labels, all within the given range.
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
};

// About `target` ticks at multiples of 1, 2 or 5 times a power of ten; optionally whole numbers only.
Ticks linear_ticks(double lower, double upper, int target, bool whole_numbers = false);

// Ticks of a logarithmic axis: decades, with 2 and 5 of each decade if they are few. All values must be > 0.
Ticks logarithmic_ticks(double lower, double upper, int target);

// A number as in print: 2e-5 becomes 2·10⁻⁵, 1e3 becomes 10³, and a minus has the width of a plus.
std::string printed_number(const std::string& number);

// The range with a margin on both sides: a fraction of its length, or of the value if all values are equal.
struct AxisSpan {
  double lower;
  double upper;
};
AxisSpan padded(double lower, double upper, double fraction);

}  // namespace scree::charts
