#pragma once

#include <string>

#include <scree/charts/chart_spec.hpp>

namespace scree::charts {

// The chart with NaN for both coordinates of points that cannot be drawn, without such points at the ends of
// curves, and with text that can be drawn. note: receives how many points are left out, in a sentence, or "".
// Throws Error if no point is left, and if a series has no points or x and y of different length.
ChartSpec drawable_chart(const ChartSpec& spec, std::string& note);

}  // namespace scree::charts
