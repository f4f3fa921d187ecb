#pragma once

#include "mode_fit.hpp"
#include "scree/signals/peaks.hpp"

#include <optional>

namespace scree::signals {

// A pole in a response, beside other poles (whose frequencies and widths the fit shifts), a straight line, and a
// background of noise and of modes that no fit tells apart (mode_background.hpp). The widths and the strengths of
// the background are not known: the numbers of the mode are means and standard deviations over all of them, and over
// frequency and width of the pole, each weighed by its likelihood.
struct ModeEstimate {
  Mode mode;
  double criterion = 0;  // Akaike's, corrected, of the likeliest background
};

// From a pole near the estimate, in a response that reaches a few widths about it. Nothing with too few frequencies
// for the numbers of the fit, and where it leaves the pole: by more than its width, or to another width than 0.15 to
// 4 of it.
std::optional<ModeEstimate> estimate_mode(const Response& response, const Pole& pole,
                                          const std::vector<Pole>& others);

}  // namespace scree::signals
