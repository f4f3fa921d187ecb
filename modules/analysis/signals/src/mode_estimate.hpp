#pragma once

#include "mode_fit.hpp"

#include <optional>

namespace scree::signals {

// A pole in a response beside other poles (whose frequencies and widths the fit shifts), a straight line, and
// a background of noise and of modes that no fit tells apart (mode_background.hpp). Widths and strengths of
// the background are unknown: the numbers of the mode are means, with standard deviations, over all of them
// and over frequency and width of the pole, weighted by likelihood.
struct ModeEstimate {
  FittedMode mode;
  double criterion = 0;  // Akaike's, corrected, of the most likely background
};

// Starts from a pole near the estimate; the response reaches a few widths on both sides of it. nullopt with
// too few frequencies for the fit, and if the fit leaves the pole: by more than a width, or to below 0.15 or
// above 4 widths.
std::optional<ModeEstimate> estimate_mode(const ResponseSpectrum& response, const Pole& pole,
                                          const std::vector<Pole>& others);

}  // namespace scree::signals
