#pragma once

#include "start.hpp"

#include <functional>

#include <scree/spectrum/road_spectrum.hpp>

namespace scree::spectrum {

// Throws Error at a column that cannot have a linear response, before anything is solved.
void check_linear(const Start& start);

// The same by its solution at the lowest frequency, for results that would be lost. Throws Error as add_linear() does.
void check_response(const Start& start);

// The linear response about the start: stiffness, damping and masses of the present contacts, solved at each frequency
// that `road` lacks; columns are linearised by central differences along the motion. Returns false if it was stopped: then the road
// has the frequencies found so far, in `linearity` the change of the columns with the size of the difference, and is to be given
// again. Throws Error if nothing is held, a law has no derivatives, or a column does not depend on positions and velocities alone.
// on_part: called after each part of the frequencies.
bool add_linear(
    const Start& start, RoadSpectrum& road, const std::function<void()>& on_part = [] {});

// The road as it is shown: `linearity` there is of pulses.
RoadSpectrum without_linearity(RoadSpectrum road);

// The whole road. Throws Error (interrupted) if it was stopped.
RoadSpectrum linear_spectrum(const Start& start);

}  // namespace scree::spectrum
