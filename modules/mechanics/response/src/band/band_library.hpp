#pragma once

#include "band/backend/band_backend.hpp"

namespace scree::response {

// The library of factorisations for the best instruction level of the processor, loaded by the first call.
// Throws Error if it is missing.
const BandBackendFactory& band_library();

}  // namespace scree::response
