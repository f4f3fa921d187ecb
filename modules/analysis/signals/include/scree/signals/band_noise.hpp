#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace scree::signals {

// Noise of rms 1 with nothing outside the multiples first..last of 1 / (length of the record), where first >
// 0 and last < count / 2. The record can be repeated. normal: draws independent normal deviates; 2 (last -
// first + 1) are drawn. Throws Error for an empty band.
std::vector<double> band_noise(std::size_t count, std::size_t first, std::size_t last,
                               const std::function<double()>& normal);

}  // namespace scree::signals
