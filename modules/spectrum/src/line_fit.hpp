#pragma once

#include "scree/spectrum/amplitude_spectrum.hpp"

#include <span>
#include <vector>

namespace scree::spectrum {

// A line whose frequency is fitted too, from one nearer than 1 / (2 length of the record). Throws Error as a lock-in does.
FoundLine fitted_line(double frequency, std::span<const double> times, std::span<const double> values);

// Each line in turn from the record less all others, a few times over.
void fit_together(std::span<const double> times, std::span<const double> values,
                  std::vector<FoundLine>& lines);

}  // namespace scree::spectrum
