#pragma once

#include <string>

#include <scree/pictures/chart_spec.hpp>

namespace scree::pictures {

// The chart with NaN for both coordinates of points that cannot be drawn, and without those at the ends of curves.
// note: receives how many there are, in a sentence, or "". Throws Error if no point is left.
ChartSpec drawable_chart(const ChartSpec& spec, std::string& note);

}  // namespace scree::pictures
