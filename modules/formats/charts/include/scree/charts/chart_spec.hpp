#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace scree::charts {

enum class LineStyle { solid, dashed, dotted, dash_dotted, none };

// One curve. Points are connected in the given order, not sorted by x. Those with a coordinate that is not
// finite, or has no logarithm on a logarithmic axis, are gaps; their number stands below the title.
struct ChartSeries {
  std::string name;       // for the legend
  std::vector<double> x;  // one or more
  std::vector<double> y;  // same length as x
  std::optional<std::array<double, 3>>
      color{};  // red, green, blue in 0..1; absent: next of a colour-blind-safe cycle
  LineStyle line =
      LineStyle::solid;  // without a colour dashed and dotted too where the cycle of colours begins again
  bool markers = false;
  std::vector<double> y_error = {};  // half the length of a bar at each point; NaN: none there; empty: none
};

// A chart: curves with common axes.
struct ChartSpec {
  std::string title;
  std::string x_label;  // with the unit, for example "time (s)"
  std::string y_label;
  std::vector<ChartSeries> series;  // at least one; with two or more the chart has a legend
  bool log_x = false;
  bool log_y = false;
};

}  // namespace scree::charts
