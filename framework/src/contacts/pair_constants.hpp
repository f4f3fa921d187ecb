#pragma once

#include "contacts/contacts.hpp"

#include <array>

#include <scree/particles.hpp>
#include <scree/plugin/abi.h>
#include <scree/thread_pool.hpp>

namespace scree {

// Properties of pairs that are constant between neighbour searches, and the forces of the last evaluation.
struct PairConstants {
  // Inputs of laws from SCREE_REDUCED_MASS to SCREE_EFFECTIVE_RADIUS.
  static constexpr std::uint32_t column_count = SCREE_ORIENTATION_A - SCREE_REDUCED_MASS;

  // Recomputes the constants of all pairs, padding included. reads: bits of the inputs that any law reads,
  // only these are stored; forces: whether per-contact forces are stored.
  void update(const Contacts& contacts, const Particles& particles, std::uint32_t reads, bool forces,
              ThreadPool& threads);
  std::size_t bytes_per_pair() const;

  scree::Column<double> radius_sum;  // R_a + R_b, for a plane R_a; −1 for padding, which never touches (m)
  std::array<PairColumns, column_count> terms;
  PairColumns force;  // (3, 2 or 0 columns) on a in the last evaluation (N)
};

}  // namespace scree
