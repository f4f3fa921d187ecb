#pragma once

#include "machine/lanes.hpp"

#include <vector>

#include <scree/column.hpp>
#include <scree/particles.hpp>
#include <scree/plugin/abi.h>

namespace scree::kernel {

// Planes in the record format of bodies, for the gather phase: a body without radius and spin at the plane's
// point.
class PlaneRecords {
 public:
  void set(const std::vector<scree_plane>& planes, std::size_t width) {
    records_.resize(width * planes.size(), 0.0);
    normals_.resize(4 * planes.size(), 0.0);
    for (std::size_t w = 0; w < planes.size(); ++w) {
      double* const record = records_.data() + width * w;
      set_part(record + record::position, planes[w].point);
      set_part(record + record::motion, planes[w].velocity);
      set_part(record + record::mid_motion, planes[w].mid_velocity);
      set_part(normals_.data() + 4 * w, planes[w].normal);
    }
  }

  const double* records() const { return records_.data(); }
  const double* normals() const { return normals_.data(); }  // (planes, 4)

 private:
  static void set_part(double* part, const double (&v)[3]) { store_four(part, Four{v[0], v[1], v[2], 0}); }

  Column<double> records_, normals_;
};

}  // namespace scree::kernel
