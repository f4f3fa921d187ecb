#pragma once

#include "offscreen_context.hpp"

#include <scree/snapshot/chart_spec.hpp>

namespace scree::snapshot {

// Throws scree::Error where a series is empty, uneven, not finite, or not > 0 on a logarithmic axis.
Picture chart_picture(OffscreenContext& context, const ChartSpec& spec);

}  // namespace scree::snapshot
