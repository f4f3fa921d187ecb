#pragma once

#include "start.hpp"

#include <scree/sound/road_spectrum.hpp>

namespace scree::sound {

// The response to one pulse, until it has decayed, and to one of half the amplitude: response over drive by their
// Fourier sums; to noise, by averages over segments. Throws Error (interrupted) if it was stopped.
RoadSpectrum pulse_spectrum(const Start& start);

}  // namespace scree::sound
