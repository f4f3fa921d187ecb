#pragma once

#include "start.hpp"

#include <scree/sound/road_spectrum.hpp>

namespace scree::sound {

// The response of the contact network as it is, by linear algebra; columns are linearised by central differences along the
// motion. Throws Error if a column does not depend on positions and velocities alone.
RoadSpectrum linear_spectrum(const Start& start);

}  // namespace scree::sound
