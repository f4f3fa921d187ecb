#pragma once

#include "mode_fit.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace scree::signals {

inline constexpr double reach = 3;              // widths on each side of a mode that its fit takes
inline constexpr std::size_t least_values = 8;  // of a fit: a pole and a background have eight numbers

// Indices [begin, end) of the frequencies of a fit, and the poles from which it starts.
struct FitRange {
  std::size_t begin, end;
  std::vector<Pole> poles;
};

// Modes that are fitted together, and their latest fit.
struct Group {
  FitRange range;
  ModeFit fit;
};

// Index of the first frequency that is not below this one (Hz).
std::size_t index_of(const ResponseSpectrum& response, double frequency);

// The frequencies within so many widths on each side of a pole, from which its fit starts.
FitRange range_about(const ResponseSpectrum& response, const Pole& pole, double widths);

ResponseSpectrum slice(const ResponseSpectrum& whole, const FitRange& range);

// Whether a pole lies within a response that has four or more frequencies in its width.
bool is_within(const Pole& pole, const ResponseSpectrum& response);

// Subtracts a pole from a response, which must not be of amplitudes.
void subtract(const Pole& pole, ResponseSpectrum& response);

// A range of the response without the modes of all groups but one. Poles outside the range of their own fit
// are background there and are not subtracted elsewhere. From amplitudes nothing is subtracted.
ResponseSpectrum without_other_groups(const ResponseSpectrum& whole, const std::vector<Group>& groups,
                                      std::size_t number, const FitRange& range);

// Fits one pole of a group again within six widths (mode_estimate.hpp), less the flanks of the poles beyond.
// The mode is the mean of up to three estimates by Akaike's weights: of the pole alone, beside the poles
// there of half its height or more, and beside all; each pole that is added makes an estimate less likely by
// exp(-20). Errors cover the differences. A background does not add linearly to amplitudes: there, and where
// no estimate succeeds, the mode is the pole of the group, with errors for as many numbers as are independent
// by the correlation of residuals. nullopt if an error exceeds half the height or width, or the height twice
// the largest response within the width.
std::optional<FittedMode> refit_locally(const ResponseSpectrum& whole, const std::vector<Group>& groups,
                                        std::size_t group, std::size_t pole);

}  // namespace scree::signals
