#pragma once

#include <vector>

#include <scree/charts/ticks.hpp>

namespace scree::charts {

// Maps data to 0..1 along an axis.
class AxisScale {
 public:
  // lower and upper: finite, > 0 if logarithmic; pad: margin at both ends, as a fraction of the range.
  AxisScale(double lower, double upper, bool logarithmic, double pad);

  double position(double value) const;
  // About `target` ticks, their labels as in print.
  Ticks ticks(int target) const;
  // Values between the powers of ten of a logarithmic axis of at most ten; else none.
  std::vector<double> minor_ticks() const;

 private:
  double raw(double value) const;

  bool logarithmic_;
  double lower_;  // of the value or of its decimal logarithm
  double upper_;
};

}  // namespace scree::charts
