#pragma once

#include <vector>

#include <scree/column.hpp>
#include <scree/particles.hpp>
#include <scree/plugin_abi.h>

namespace scree::kernel {

// What contacts read of planes, as bodies' records: a body without radius at the plane's point that does not
// turn.
class PlaneRecords {
 public:
  void set(const std::vector<scree_plane>& planes, std::size_t width) {
    records_.resize(width * planes.size(), 0.0);
    normals_.resize(4 * planes.size(), 0.0);
    for (std::size_t w = 0; w < planes.size(); ++w)
      for (std::size_t k = 0; k < 3; ++k) {
        double* record = records_.data() + width * w;
        record[record::place + k] = planes[w].point[k];
        record[record::motion + k] = planes[w].velocity[k];
        record[record::mid_motion + k] = planes[w].mid_velocity[k];
        normals_[4 * w + k] = planes[w].normal[k];
      }
  }

  const double* records() const { return records_.data(); }
  const double* normals() const { return normals_.data(); }  // (planes, 4)

 private:
  Column<double> records_, normals_;
};

}  // namespace scree::kernel
