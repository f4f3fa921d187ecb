#pragma once

#include <scree/body_range.hpp>
#include <scree/column.hpp>
#include <scree/particles.hpp>

namespace scree::kernel {

// Where the parts of a body's record are (doubles), each of four doubles:
//   3D  place (x, y, z, R), motion (v, 0), with spin: mid_motion (v, 0), spin (ω, 0), mid_spin (ω, 0)
//   2D  place (x, y, 0, R), motion (v, mid v), with spin: spin (ω, mid ω, 0, 0)
template <int D, bool with_spin>
struct RecordLayout {
  static constexpr std::size_t place = 0, motion = 4, spin = 8, mid_motion = 12, mid_spin = 16;
  static constexpr std::size_t width = !with_spin ? 8 : D == 2 ? 12 : 20;
};

// What contacts read of bodies, copied from the columns into one record each, so that the partner of a pair
// costs one address and a few whole cache lines.
class BodyRecords {
 public:
  void resize(const Particles& particles);
  void pack(const Particles& particles, BodyRange bodies);

  const double* data() const { return records_.data(); }
  std::size_t bytes_per_body() const { return width_ * sizeof(double); }

 private:
  std::size_t width_ = 0;
  Column<double> records_;
};

// The way back: writes component k of each record, `stride` doubles apart, to columns[k] unless that is null.
void deal_out(const double* records, std::size_t stride, double* const (&columns)[4], BodyRange bodies);

}  // namespace scree::kernel
