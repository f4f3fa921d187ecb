#pragma once

#include "band/backend/band_backend.hpp"

namespace scree::response {

// The library of factorisations for the best instruction level that the processor has, loaded on the first call. Throws
// Error if it is missing.
const BandBackendFactory& band_library();

}  // namespace scree::response
