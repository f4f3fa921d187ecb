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

// Gathers orientations, separations and radii of the pairs [begin, begin + count), as far as the scene carries
// them, after `gather`, and passes them to the law. Not inlined into the loops over blocks, which rarely need it.
template <bool planes, class T>
void gather_placement(const EvaluationInput& input, std::size_t begin, std::uint32_t count,
                      BlockColumns<T>& block);

}  // namespace scree::kernel
