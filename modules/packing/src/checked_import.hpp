#pragma once

#include "scree/packing/packing.hpp"

#include <string>

namespace scree::packing {

// The packing, after check(); its errors then begin with the name of the file.
Packing checked_import(Packing packing, const std::string& name);

}  // namespace scree::packing
