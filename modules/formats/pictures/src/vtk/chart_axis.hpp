#pragma once

#include "ticks.hpp"

class vtkAxis;

namespace scree::pictures {

// Maps data to 0..1 along an axis. VTK draws in single precision; in this range the rounding is invisible.
class ChartScale {
 public:
  // lower and upper: finite, > 0 if logarithmic; pad: margin at both ends, as a fraction of the range.
  ChartScale(double lower, double upper, bool logarithmic, double pad);

  double position(double value) const;
  Ticks ticks(int target) const;

  // Sets the ticks of a VTK axis. font: height of the labels in drawn pixels.
  void apply(vtkAxis* axis, const Ticks& ticks, double font) const;

 private:
  double raw(double value) const;

  bool logarithmic_;
  double lower_;  // of the value or of its decimal logarithm
  double upper_;
};

}  // namespace scree::pictures
