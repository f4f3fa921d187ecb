#pragma once

#include "mode_fit.hpp"
#include "scree/signals/peaks.hpp"

namespace scree::signals {

// The numbers of one pole of a fit, with their errors.
Mode mode_of(const ModeFit& fit, std::size_t number, const Response& response);

// Whether a pole is seen beside the others of its fit: over its width w it changes the response by its height A, and they change it by
// about w |dH_others/df|. Below a quarter of that, it is a part of their background.
bool stands_out(const ModeFit& fit, std::size_t number, bool only_amplitudes);

}  // namespace scree::signals
