#pragma once

#include "contacts/contacts.hpp"

#include <array>

#include <scree/particles.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// What does not change for a pair from one neighbour search to the next, and what contacts leave for it.
struct PairConstants {
  // Inputs of laws from SCREE_REDUCED_MASS on.
  static constexpr std::uint32_t column_count = SCREE_CONTACT_INPUT_COUNT - SCREE_REDUCED_MASS;

  explicit PairConstants(Precision precision) : force(precision) { terms.fill(PairColumns(precision)); }

  // For all pairs, padding included; reads: bits of the inputs that any law reads, others are left out;
  // forces: whether those of pairs are kept.
  void update(const Contacts& contacts, const Particles& particles, std::uint32_t reads, bool forces);
  std::size_t bytes_per_pair() const;

  scree::Column<double> radius_sum;  // R_a + R_b, of a plane R_a; −1 for padding, which never touches (m)
  std::array<PairColumns, column_count> terms;
  PairColumns force;  // (3, 2 or none) on a at the last evaluation (N)
};

}  // namespace scree
