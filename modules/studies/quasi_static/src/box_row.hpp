#pragma once

#include "loaded_packing.hpp"

#include <string>
#include <vector>

#include <scree/plugin/abi.h>

namespace scree::quasi_static {

// Columns of a series, with units: as of the probe `box`, along the axes that have walls at both ends, then
// contacts, sliding, dynamic.
class BoxRow {
 public:
  // at_start: as lengths().
  explicit BoxRow(const std::vector<double>& at_start);

  std::string head() const;  // line of a CSV file
  std::string line(const Sample& sample) const;
  // Along an axis (m), and 0 if it has no walls.
  static double length(const Sample& sample, int axis);
  static std::vector<double> lengths(int dimension, const Sample& sample);
  // L_y/L_y0 − L_x/L_x0, or NaN without these walls.
  double deviatoric_strain(const Sample& sample) const;

 private:
  struct Axis {
    int axis;
    double length_at_start;  // (m)
  };
  double strain(const Sample& sample, const Axis& along) const;
  double stress(const Sample& sample, int axis) const;

  int dimension_;
  std::vector<Axis> axes_;
};

}  // namespace scree::quasi_static
