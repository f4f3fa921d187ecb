#pragma once

#include "equilibrium/static_configuration.hpp"
#include "equilibrium/static_contacts.hpp"

#include <scree/state.hpp>

namespace scree::response {

// The state of a simulation with its bodies and walls elsewhere, at rest and in balance, with other contacts, at another time (s).
State static_state(const Simulation& simulation, double time, const StaticConfiguration& at,
                   const std::vector<TouchingPair>& contacts, const StaticLoads& loads);

}  // namespace scree::response
