#pragma once

#include "scree/spectrum/amplitude_spectrum.hpp"

#include <functional>
#include <span>
#include <vector>

namespace scree::spectrum {

// A line whose frequency is fitted too, from one nearer than 1 / (2 length of the record). Throws Error as a lock-in does.
FoundLine fitted_line(double frequency, std::span<const double> times, std::span<const double> values);

// Takes a line out of a record.
void subtract(const FoundLine& line, std::span<const double> times, std::vector<double>& values);

// What others leave in a line falls by its share in them, some 0.05 at five resolutions, with each round.
inline constexpr std::size_t rounds_together = 6;

// Each line in turn from the record less all others, in rounds. on_progress receives the share that is done.
void fit_together(std::span<const double> times, std::span<const double> values,
                  std::vector<FoundLine>& lines, const std::function<void(double)>& on_progress);

}  // namespace scree::spectrum
