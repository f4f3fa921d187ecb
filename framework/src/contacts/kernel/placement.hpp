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

// Pairs [begin, begin + count), with the row of the first one among the records of surfaces.
struct PairsToPlace {
  const EvaluationInput& input;
  std::size_t begin;
  std::uint32_t count;
  std::size_t surface_row;
};

// After `gather`: gathers what the law reads of orientations, separations, radii and turning normals, and
// passes it to the law. Not inlined into the loops over blocks, which rarely need it.
template <Partner partner>
void gather_placement(const PairsToPlace& pairs, const scree_contact_instance& law, BlockColumns& block);

}  // namespace scree::kernel
