#pragma once

#include "mode_group.hpp"
#include "scree/spectrum/peaks.hpp"

namespace scree::spectrum {

// One pole of a group, fitted anew near itself so that misfits elsewhere do not move it: within three widths, with the poles there, less
// the flanks of all others. Its errors are those of the fit, with as many numbers as are independent by the correlation of residuals. Where these are correlated, or a
// change is beyond the noise, they cover what other choices change: two and one and a half widths, a parabola as background, no poles that others hide, the fit of
// the group. Where that fit fails, and of amplitudes, whose flanks cannot be subtracted, the pole is as its group has it.
Mode near_mode(const Response& whole, const std::vector<Group>& groups, std::size_t group, std::size_t pole);

}  // namespace scree::spectrum
