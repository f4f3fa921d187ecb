#pragma once

#include "contacts/kernel/block.hpp"

namespace scree::kernel {

// Whether a law reads orientations.
inline bool reads_orientations(const scree_contact_instance& law) {
  return law.reads & (1u << SCREE_ORIENTATION_A | 1u << SCREE_ORIENTATION_B);
}

// Gathers the orientations of the pairs [begin, begin + count) and passes them to the law. Not inlined into
// the loops over blocks, which rarely need it.
template <bool planes, class T>
void gather_orientations(const EvaluationInput& input, std::size_t begin, std::uint32_t count,
                         BlockColumns<T>& block);

}  // namespace scree::kernel
