#pragma once

#include <array>
#include <cairo.h>
#include <vector>

#include <scree/charts/chart_spec.hpp>

namespace scree::charts {

enum class Marker { none, circle, square, diamond };

// Style of series number `index`, in the plot and in the legend.
struct CurveStyle {
  std::array<double, 3> color;
  LineStyle line;
  Marker marker;

  static CurveStyle of(const ChartSeries& series, std::size_t index);
};

// A point of the picture (pixels from the upper left).
struct Point {
  double x, y;
};

// The line without points that are not seen: of consecutive points in the same half pixel of x the first, the
// last, the highest and the lowest are kept. Points that are NaN are kept.
std::vector<Point> thinned(const std::vector<Point>& line);

// Draws a curve with gaps at points that are NaN. font: size of the labels (pixels), for widths, dashes and
// markers.
void draw_curve(cairo_t* cairo, const std::vector<Point>& points, const CurveStyle& style, double font);

}  // namespace scree::charts
