#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace scree::signals {

// Hann window of a period of `count` samples: sin^2(pi j / count).
std::vector<double> hann(std::size_t count);

// Subtracts the straight line that fits best.
void remove_line(std::span<double> values);

}  // namespace scree::signals
