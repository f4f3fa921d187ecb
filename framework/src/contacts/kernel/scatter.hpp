#pragma once

#include "contacts/kernel/block.hpp"

namespace scree::kernel {

// Adds forces and torques of four pairs to the slots of a, and the opposite forces to the slots of b, one
// pair after the other, since a body may be part of several.
template <int D, bool spin>
SCREE_HOT void scatter_four(const double* const (&force)[3], const std::uint32_t* slot_a,
                            const std::uint32_t* slot_b, std::uint32_t lane, const BlockColumns& block,
                            double* slots) {
  constexpr std::size_t width = record::load_width(D, spin);
  Four f[4] = {}, torque_a[4] = {}, torque_b[4] = {};
  for (int k = 0; k < D; ++k) f[k] = load_four(force[k] + lane);
  if constexpr (spin)
    for (int k = 0; k < spin_components<D>; ++k) {
      torque_a[k] = load_four(block.torque[0][k] + lane);
      torque_b[k] = load_four(block.torque[1][k] + lane);
    }
  if constexpr (D == 2) {
    Four on_b[4] = {-f[0], -f[1], torque_b[0], f[3]};
    f[2] = torque_a[0];
    transpose(f[0], f[1], f[2], f[3]);
    transpose(on_b[0], on_b[1], on_b[2], on_b[3]);
    for (int p = 0; p < 4; ++p) {
      add_four(slots + width * slot_a[p], f[p]);
      add_four(slots + width * slot_b[p], on_b[p]);
    }
  } else {
    transpose(f[0], f[1], f[2], f[3]);
    if constexpr (spin) {
      transpose(torque_a[0], torque_a[1], torque_a[2], torque_a[3]);
      transpose(torque_b[0], torque_b[1], torque_b[2], torque_b[3]);
    }
    for (int p = 0; p < 4; ++p) {
      double *a = slots + width * slot_a[p], *b = slots + width * slot_b[p];
      add_four(a, f[p]);
      add_four(b, -f[p]);
      if constexpr (spin) add_four(a + 4, torque_a[p]), add_four(b + 4, torque_b[p]);
    }
  }
}

}  // namespace scree::kernel
