#pragma once

#include "chart_layout.hpp"

#include <array>
#include <vector>

namespace scree::pictures {

// Style of series number `index`, in the plot and in the legend.
struct CurveStyle {
  std::array<double, 3> color;
  LineStyle line;
  int marker;          // of vtkPlotPoints
  double line_width;   // (drawn pixels)
  double marker_size;  // (drawn pixels)

  static CurveStyle of(const ChartSeries& series, std::size_t index, double font);
};

// The drawn pieces of a line as pairs of end points (x, y, x, y in drawn pixels), without those to points that are NaN;
// dashes and dots scale with the font.
std::vector<float> line_pieces(const std::vector<double>& x, const std::vector<double>& y, LineStyle style,
                               double font);

}  // namespace scree::pictures
