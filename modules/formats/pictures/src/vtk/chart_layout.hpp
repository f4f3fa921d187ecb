#pragma once

#include "chart_axis.hpp"

#include <optional>
#include <string>
#include <vector>

#include <scree/pictures/chart_spec.hpp>

namespace scree::pictures {

// A rectangle in drawn pixels from the lower left.
struct Box {
  double left;
  double bottom;
  double width;
  double height;
};

// Positions of all parts of a chart.
struct ChartLayout {
  double width;   // (drawn pixels) of the whole picture
  double height;  // (drawn pixels)
  double font;    // (drawn pixels) of the labels
  std::vector<std::string> title_lines;
  std::string note;  // below the title
  ChartScale x;
  ChartScale y;
  Ticks x_ticks;
  Ticks y_ticks;
  Box plot;
  std::optional<Box>
      legend;  // with two or more series: in a corner without curves, or beside the plot if there is none

  // spec: as drawable_chart() returns it.
  static ChartLayout of(const ChartSpec& spec, const std::string& note);
};

// Rows of the legend.
inline constexpr double legend_line = 1.5;    // (fonts) from row to row
inline constexpr double legend_sample = 2.4;  // (fonts) length of the sample line
inline constexpr double legend_pad = 0.6;     // (fonts) around and between

}  // namespace scree::pictures
