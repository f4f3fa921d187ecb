#pragma once

#include "ticks.hpp"

class vtkAxis;

namespace scree::snapshot {

// Maps data to 0..1 along an axis. VTK draws in single precision; on this scale that loses nothing that can
// be seen.
class ChartScale {
 public:
  // Ends finite and, if logarithmic, > 0; pad: free share at both ends.
  ChartScale(double lower, double upper, bool logarithmic, double pad);

  double place(double value) const;
  Ticks ticks(int wanted) const;

  // Gives a VTK axis these marks. font: height of the labels in drawn pixels.
  void apply(vtkAxis* axis, const Ticks& ticks, double font) const;

 private:
  double raw(double value) const;

  bool logarithmic_;
  double lower_;  // of the value or of its decimal logarithm
  double upper_;
};

}  // namespace scree::snapshot
