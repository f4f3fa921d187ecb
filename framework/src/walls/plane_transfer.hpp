#pragma once

#include <vector>

#include <scree/plugin/abi.h>
#include <scree/state_transfer.hpp>

namespace scree {

// Saves or restores planes; as many as there are must be in the state.
void transfer_planes(const StateTransfer& state, std::vector<scree_plane>& planes);

}  // namespace scree
