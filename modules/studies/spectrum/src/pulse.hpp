#pragma once

#include "start.hpp"

#include <scree/spectrum/road_spectrum.hpp>

namespace scree::spectrum {

// The response to one pulse, until it has decayed, and to one of half the amplitude: response over drive by their
// Fourier sums; to noise, by averages over segments. Throws Error (interrupted) if it was stopped.
RoadSpectrum pulse_spectrum(const Start& start);

}  // namespace scree::spectrum
