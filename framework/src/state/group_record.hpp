#pragma once

#include <vector>

#include <scree/body_group.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

// Saves names, bodies and functions of time below a path of the state; nothing without groups.
void save_groups(const StateTransfer& state, const std::vector<BodyGroup>& groups);
void save_selections(const StateTransfer& state, const std::vector<BodySelection>& selections);

}  // namespace scree
