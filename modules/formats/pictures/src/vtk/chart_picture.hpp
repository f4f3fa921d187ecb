#pragma once

#include "offscreen_context.hpp"

#include <scree/pictures/chart_spec.hpp>

namespace scree::pictures {

// Throws scree::Error if a series is empty, has x and y of different length, is not finite, or is not > 0 on
// a logarithmic axis.
Picture chart_picture(OffscreenContext& context, const ChartSpec& spec);

}  // namespace scree::pictures
