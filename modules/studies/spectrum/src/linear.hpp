#pragma once

#include "start.hpp"

#include <functional>
#include <vector>

#include <scree/spectrum/method_spectrum.hpp>

namespace scree::spectrum {

// Throws Error at a column that cannot have a linear response, before anything is solved.
void check_linear(const Start& start);

// Solves at the lowest frequency, before results are replaced. Throws Error as add_linear() does.
void check_response(const Start& start);

// The linear response about the start: stiffness, damping and masses of the present contacts, solved at each
// frequency that `spectrum` lacks; columns are linearised by central differences along the motion. Returns
// false after a stop: then `spectrum` has the frequencies so far, and in `linearity` the change of the
// columns with the size of the difference; give it again to continue. Throws Error if nothing is held, a law
// has no derivatives, or a column depends on more than positions and velocities. on_part: called after each
// part of the frequencies.
bool add_linear(
    const Start& start, MethodSpectrum& spectrum, const std::function<void()>& on_part = [] {});

// The spectrum as it is shown: `linearity` there belongs to pulses.
MethodSpectrum without_linearity(MethodSpectrum spectrum);

// The spectrum at all frequencies. Throws Error (interrupted) if it was stopped.
MethodSpectrum linear_spectrum(const Start& start);

}  // namespace scree::spectrum
