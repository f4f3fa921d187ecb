#pragma once

#include "mode_fit.hpp"

#include <cstddef>
#include <vector>

namespace scree::signals {

// Noise (rms) near each value.
std::vector<double> noise_of(const Response& response);

// Maxima from which the values fall on both sides by more than the threshold there; not the first and last value.
std::vector<std::size_t> maxima(const std::vector<double>& values, const std::vector<double>& threshold);

}  // namespace scree::signals
