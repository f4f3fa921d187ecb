#pragma once

#include <vector>

#include <scree/plugin/abi.h>
#include <scree/state_transfer.hpp>

namespace scree {

// Saves or restores frames, whose number is known.
void transfer_frames(const StateTransfer& state, std::vector<scree_frame>& frames);

}  // namespace scree
