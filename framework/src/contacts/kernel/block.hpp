#pragma once

#include "contacts/contacts.hpp"
#include "contacts/forces.hpp"
#include "contacts/kernel/partner.hpp"
#include "contacts/kernel/plane_records.hpp"
#include "contacts/kernel/surface_records.hpp"
#include "machine/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <scree/plugin/abi.h>

namespace scree::kernel {

// Number of pairs per call of a law; their columns fit into the first-level cache.
inline constexpr std::uint32_t block_size = 48;

// Input common to all blocks of an evaluation.
struct EvaluationInput {
  const Contacts& contacts;
  const double* records;
  const Particles& particles;
  const PlaneRecords& planes;
  const Domain& domain;
  const double* shifts;  // (27, 4) periodic shift for each image code (m)
  bool periodic;
  double step;  // (s) since the last evaluation
  double kick;  // (s) for which the forces act
  bool audit, pair_forces;
  double max_overlap_ratio;                  // largest in earlier evaluations
  const SurfaceRecords* surfaces = nullptr;  // if there are pairs with surfaces
  double* slips = nullptr;                   // of these pairs, see SurfaceRecords
};

// Columns of a block of pairs between gather and scatter.
struct alignas(64) BlockColumns {
  double separation[3][block_size];      // x_a − x_b (m); for a plane x_a − point
  double radius_difference[block_size];  // R_a − R_b (m)
  double distance[block_size];
  double velocity[3][block_size], mid_velocity[3][block_size];  // a − b (m/s)
  double spin[2][3][block_size], mid_spin[2][3][block_size];    // of a, of b (rad/s)
  double input[SCREE_REDUCED_MASS][block_size];                 // of the law, as in scree_contact_input
  double lever[3][block_size], mid_normal[3][block_size];       // of surfaces, see SurfaceRecords
  double ones[block_size];                                      // onset weights of blocks that need none
  double output[SCREE_CONTACT_OUTPUT_COUNT][block_size];        // stored pair forces bypass this
  double torque[2][3][block_size];                              // on a, on b (N m)
  scree_contact_batch batch;                                    // argument of the law
  // For laws that read them.
  double orientation[2][4][block_size];  // of a, of b
  double placement[3][block_size];       // separation (m)
  double radius[2][block_size];          // of a, of b (m)
  double normal_change[6][block_size];   // of surfaces
};

}  // namespace scree::kernel
