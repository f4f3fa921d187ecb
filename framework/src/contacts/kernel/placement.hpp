#pragma once

#include "contacts/kernel/block.hpp"

namespace scree::kernel {

// Whether a law reads orientations.
inline bool reads_orientations(const scree_contact_instance& law) {
  return law.reads & (1u << SCREE_ORIENTATION_A | 1u << SCREE_ORIENTATION_B);
}

// Whether a law reads orientations, separations or radii.
inline bool reads_placement(const scree_contact_instance& law) {
  return reads_orientations(law) || (law.reads & (1u << SCREE_SEPARATION | 1u << SCREE_RADII));
}

// Whether a law follows bodies along their paths.
inline bool reads_paths(const scree_contact_instance& law) {
  return reads_orientations(law) || (law.reads & (1u << SCREE_SEPARATION));
}

// After `gather`: gathers what the law reads of orientations, separations and radii of the pairs [begin,
// begin + count), and passes it to the law. Not inlined into the loops over blocks, which rarely need it.
template <bool planes>
void gather_placement(const EvaluationInput& input, const scree_contact_instance& law, std::size_t begin,
                      std::uint32_t count, BlockColumns& block);

}  // namespace scree::kernel
