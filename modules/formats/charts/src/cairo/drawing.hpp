#pragma once

#include "layout.hpp"

#include <cairo.h>

namespace scree::charts {

// Draws a chart of chart_width x chart_height.
void draw(cairo_t* cairo, const ChartSpec& spec, const Layout& layout);

}  // namespace scree::charts
