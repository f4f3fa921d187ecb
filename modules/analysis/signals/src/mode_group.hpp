#pragma once

#include "mode_fit.hpp"

#include <cstddef>
#include <vector>

namespace scree::signals {

inline constexpr double reach = 3;              // widths on each side of a mode that its fit takes
inline constexpr std::size_t least_values = 8;  // of a fit: a pole and a background have eight numbers

// Indices [begin, end) that are fitted together, and where to start.
struct Range {
  std::size_t begin, end;
  std::vector<Pole> poles;
};

// A range and its latest fit.
struct Group {
  Range range;
  ModeFit fit;
};

// Of the first frequency that is not below this one (Hz).
std::size_t index_of(const Response& response, double frequency);

// Within so many widths of a pole on each side, which is where its fit starts.
Range range_about(const Response& response, const Pole& pole, double widths);

Response part(const Response& whole, const Range& range);

// Whether a pole is within a range of frequencies that resolves it, by four or more in its width; these may be denser about it than
// elsewhere.
bool is_within(const Pole& pole, const Response& response);

// Not of amplitudes.
void subtract(const Pole& pole, Response& response);

// The part of the response in a range, less the modes of all groups but one. Poles beyond the range that they were fitted in are
// background there, and say nothing of other ranges. Of amplitudes nothing is subtracted.
Response alone(const Response& whole, const std::vector<Group>& groups, std::size_t number,
               const Range& range);

}  // namespace scree::signals
