#pragma once

#include "scree/packing/packing.hpp"

#include <string>

namespace scree::packing {

// Returns the packing after check(); prefixes errors with the name of the file.
Packing checked_import(Packing packing, const std::string& name);

}  // namespace scree::packing
