#pragma once

#include "loaded_packing.hpp"
#include "surface_columns.hpp"

#include <string>
#include <vector>

#include <scree/plugin/abi.h>

namespace scree::quasi_static {

// Columns of a series, with units: as of the probe `box`, along the axes that have walls at both ends, then
// surfaces that forces move, contacts, sliding, dynamic.
class BoxRow {
 public:
  // at_start: as lengths().
  explicit BoxRow(const std::vector<double>& at_start, SurfaceColumns surfaces = {});

  std::string head() const;  // line of a CSV file
  std::string line(const Sample& sample) const;
  // Along an axis (m), and 0 if it has no walls.
  static double length(const Sample& sample, int axis);
  static std::vector<double> lengths(int dimension, const Sample& sample);
  // What charts show: L_y/L_y0 − L_x/L_x0; without these walls the displacement (m) and force (N) of the
  // first surface that forces move; NaN without such a surface.
  struct Charted {
    double value, force;
  };
  Charted charted(const Sample& sample) const;
  // Of the surface; "" without.
  std::string charted_surface() const;

 private:
  struct Axis {
    int axis;
    double length_at_start;  // (m)
  };
  double strain(const Sample& sample, const Axis& along) const;
  double stress(const Sample& sample, int axis) const;
  bool has_deviatoric_strain() const;

  int dimension_;
  std::vector<Axis> axes_;
  SurfaceColumns surfaces_;
};

}  // namespace scree::quasi_static
