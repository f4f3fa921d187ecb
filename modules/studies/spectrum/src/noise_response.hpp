#pragma once

#include "pulse_record.hpp"

#include <scree/spectrum/road_spectrum.hpp>

namespace scree::spectrum {

// Frequencies and columns of a road from records that noise drove, at full and at half the amplitude, with Welch segments of 2 / step_hz
// and every second of their frequencies, which hardly correlate. Errors: that of the coherence, and the leakage of the window,
// H'' / (6 T^2) (transfer_function.hpp), from differences of neighbours.
void add_noise_response(const PulseRecord& full, const PulseRecord& half, const scenario::SpectrumPlan& plan,
                        RoadSpectrum& road);

}  // namespace scree::spectrum
