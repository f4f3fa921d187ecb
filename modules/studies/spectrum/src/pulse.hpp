#pragma once

#include "start.hpp"

#include <scree/spectrum/method_spectrum.hpp>

namespace scree::spectrum {

// The response to one pulse, recorded until it has decayed, and to one of half the amplitude: Fourier sums of
// the response over those of the drive; for noise, averages over segments. Throws Error (interrupted) if it
// was stopped.
MethodSpectrum pulse_spectrum(const Start& start);

}  // namespace scree::spectrum
