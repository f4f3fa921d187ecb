#pragma once

#include <scree/column.hpp>
#include <scree/particles.hpp>

namespace scree::kernel {

// What contacts read of bodies, gathered from the columns into records of 32 bytes, so that the partner of a
// pair costs a few whole cache lines:
//   3D  place (x, y, z, R), motion (v, 0), mid_motion (v, 0), spin (ω, 0), mid_spin (ω, 0)
//   2D  place (x, y, 0, R), motion (v, mid v), spin (ω, mid ω, 0, 0)
// Those that a scene does not read are empty.
class BodyRecords {
 public:
  // with_mid: laws read displacements of the step.
  void resize(const Particles& particles, bool with_mid);
  // Copies the bodies [begin, end); begin and end are multiples of 4 or the number of bodies.
  void pack(const Particles& particles, std::size_t begin, std::size_t end);

  std::size_t bytes_per_body() const;

  Column<double> place, motion, mid_motion, spin, mid_spin;
};

// The way back: writes component k of each record, `stride` doubles apart, to columns[k] unless that is null.
void deal_out(const double* records, std::size_t stride, double* const (&columns)[4], std::size_t begin,
              std::size_t end);

}  // namespace scree::kernel
