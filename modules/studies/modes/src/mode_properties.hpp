#pragma once

#include <vector>

#include <scree/modes/mode.hpp>
#include <scree/response/found_modes.hpp>

namespace scree::modes {

// The modes that were found, in their order.
std::vector<Mode> properties_of(const response::FoundModes& found, const response::LinearSystem& system);

// Kinetic energy of each body in all floppy modes that were found, in descending order, from 0.01 on.
std::vector<Participant> floppy_bodies(const response::FoundModes& found,
                                       const response::LinearSystem& system);

}  // namespace scree::modes
