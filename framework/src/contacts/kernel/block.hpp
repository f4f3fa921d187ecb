#pragma once

#include "contacts/contacts.hpp"
#include "contacts/forces.hpp"
#include "contacts/kernel/lanes.hpp"
#include "contacts/kernel/plane_records.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <scree/plugin/contact_batch.hpp>

namespace scree::kernel {

// Contacts a law is given in one call; what they need lies in the first-level cache.
inline constexpr std::uint32_t block_size = 48;

// What every block of an evaluation shares.
struct EvaluationInput {
  const Contacts& contacts;
  const double* records;
  const PlaneRecords& planes;
  const double* shifts;  // (27, 4) of each image code
  bool periodic;
  double step;
  bool audit, pair_forces;
  double max_overlap_ratio;  // overlap ratio met in earlier evaluations
};

// A block of pairs between gather and scatter, as columns. T is what laws compute in, double or float; only
// separations stay double, since overlaps are their small differences.
template <class T>
struct alignas(64) BlockColumns {
  double separation[3][block_size];  // x_a − x_b (m); of a plane from its point
  T radius_difference[block_size];   // R_a − R_b (m)
  T distance[block_size];
  T velocity[3][block_size], mid_velocity[3][block_size];  // a − b (m/s)
  T spin[2][3][block_size], mid_spin[2][3][block_size];    // of a, of b (rad/s)
  T input[SCREE_REDUCED_MASS][block_size];                 // of the law, as in scree_contact_input
  T ones[block_size];                                      // onset weights of blocks that need none
  T output[SCREE_CONTACT_OUTPUT_COUNT][block_size];        // forces go straight to pairs that keep them
  T torque[2][3][block_size];                              // on a, on b (N m)
  ContactBatch<T> batch;                                   // what the law is given
};

}  // namespace scree::kernel
