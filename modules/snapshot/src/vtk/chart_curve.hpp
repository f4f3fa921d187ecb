#pragma once

#include "chart_layout.hpp"

#include <array>
#include <vector>

namespace scree::snapshot {

// How series number `index` looks; the legend shows the same.
struct CurveLook {
  std::array<double, 3> color;
  LineStyle line;
  int marker;          // of vtkPlotPoints
  double line_width;   // (drawn pixels)
  double marker_size;  // (drawn pixels)

  static CurveLook of(const ChartSeries& series, std::size_t index, double font);
};

// The drawn pieces of a line as pairs of ends (x, y, x, y in drawn pixels), dashes and dots cut to the font's
// size.
std::vector<float> line_pieces(const std::vector<double>& x, const std::vector<double>& y, LineStyle style,
                               double font);

}  // namespace scree::snapshot
