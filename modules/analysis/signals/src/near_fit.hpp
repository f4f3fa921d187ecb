#pragma once

#include "mode_group.hpp"
#include "scree/signals/peaks.hpp"

#include <optional>

namespace scree::signals {

// One pole of a group, estimated anew within six widths (mode_estimate.hpp), less the flanks of poles beyond. There are
// up to three estimates: of the pole alone, beside the poles there of half its height or more, and beside all. The mode
// is their mean with Akaike's weights, each further pole less likely by exp(-20); its errors cover their differences.
// Of amplitudes, to which a background does not add linearly, and where no estimate succeeds, the mode is the pole
// of its group, with errors of as many numbers as are independent by the correlation of residuals.
// Nothing if an error is more than half the height or the width, or if the height is more than twice the largest
// response within the width: there may be no such mode.
std::optional<Mode> near_mode(const Response& whole, const std::vector<Group>& groups, std::size_t group,
                              std::size_t pole);

}  // namespace scree::signals
