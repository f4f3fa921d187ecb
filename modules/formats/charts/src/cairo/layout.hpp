#pragma once

#include "axis_scale.hpp"
#include "curve.hpp"

#include <optional>
#include <string>
#include <vector>

#include <scree/charts/chart_spec.hpp>

namespace scree::charts {

// Size of a chart and of its labels (pixels).
inline constexpr double chart_width = 1200, chart_height = 900, label_font = 22,
                        title_font = 1.25 * label_font;

// A rectangle (pixels from the upper left).
struct Box {
  double left, top, width, height;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

// Names of the curves, in a corner without curves, or beside the plot if there is none.
struct Legend {
  Box box;
  double font;  // smaller than that of the labels if there are many curves
};

// Rows of the legend.
inline constexpr double legend_line = 1.5;    // (fonts) from row to row
inline constexpr double legend_sample = 2.4;  // (fonts) length of the sample line
inline constexpr double legend_pad = 0.6;     // (fonts) around and between

// Positions of all parts of a chart.
struct Layout {
  std::vector<std::string> title_lines;
  std::string note;  // below the title
  AxisScale x, y;
  Ticks x_ticks, y_ticks;
  Box plot;
  std::optional<Legend> legend;  // with two or more series

  // spec: as drawable_chart() returns it.
  static Layout of(const ChartSpec& spec, const std::string& note);

  // Where a value is drawn; NaN for a gap.
  Point place(double x_value, double y_value) const {
    return {plot.left + x.position(x_value) * plot.width, plot.bottom() - y.position(y_value) * plot.height};
  }
};

}  // namespace scree::charts
