#include "drawable_chart.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scree/charts/text_fit.hpp>
#include <scree/counted.hpp>
#include <scree/error.hpp>

namespace scree::charts {
namespace {

struct Left {
  std::size_t points = 0, without_value = 0, without_logarithm = 0;

  std::size_t out() const { return without_value + without_logarithm; }
};

void leave_out(ChartSeries& series, bool log_x, bool log_y, Left& left) {
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    double &x = series.x[k], &y = series.y[k];
    ++left.points;
    const bool has_value = std::isfinite(x) && std::isfinite(y);
    const bool has_logarithm = !(log_x && x <= 0) && !(log_y && y <= 0);
    if (has_value && has_logarithm) continue;
    ++(has_value ? left.without_logarithm : left.without_value);
    x = y = std::numeric_limits<double>::quiet_NaN();
  }
}

// Neither lines nor the number of points are to depend on points that are not drawn.
void trim(ChartSeries& series) {
  std::size_t first = 0, last = series.x.size();
  while (last > 0 && std::isnan(series.x[last - 1])) --last;
  while (first < last && std::isnan(series.x[first])) ++first;
  for (std::vector<double>* values : {&series.x, &series.y, &series.y_error})
    if (!values->empty())
      *values = {values->begin() + std::ptrdiff_t(first), values->begin() + std::ptrdiff_t(last)};
}

std::string reason(const Left& left) {
  if (left.without_value == 0) return left.out() == 1 ? "it has no logarithm" : "they have no logarithm";
  if (left.without_logarithm == 0) return left.out() == 1 ? "it has no value" : "they have no value";
  return fmt::format("{} without logarithm, {} without value", left.without_logarithm, left.without_value);
}

void check(const ChartSpec& spec) {
  if (spec.series.empty())
    throw Error(fmt::format("chart: \"{}\" has no series; give one or more", spec.title));
  for (const ChartSeries& series : spec.series)
    if (series.x.empty() || series.x.size() != series.y.size())
      throw Error(
          fmt::format("chart: series \"{}\" has {} x and {} y values; give equal numbers, at least one",
                      series.name, series.x.size(), series.y.size()));
    else if (!series.y_error.empty() && series.y_error.size() != series.y.size())
      throw Error(
          fmt::format("chart: series \"{}\" has {} y values and {} errors; give one for each, or none",
                      series.name, series.y.size(), series.y_error.size()));
}

}  // namespace

ChartSpec drawable_chart(const ChartSpec& spec, std::string& note) {
  check(spec);
  ChartSpec drawable = spec;
  for (std::string* text : {&drawable.title, &drawable.x_label, &drawable.y_label})
    *text = drawable_text(*text);
  Left left;
  for (ChartSeries& series : drawable.series) {
    series.name = drawable_text(series.name);
    leave_out(series, spec.log_x, spec.log_y, left);
    trim(series);
  }
  if (left.out() == left.points)
    throw Error(fmt::format("chart: \"{}\": no point can be drawn ({}); {}", spec.title, reason(left),
                            left.without_logarithm ? "use linear axes" : "draw columns that have values"));
  note = left.out() == 0 ? ""
                         : fmt::format("{} of {} {} left out: {}", left.out(), counted(left.points, "point"),
                                       left.out() == 1 ? "is" : "are", reason(left));
  return drawable;
}

}  // namespace scree::charts
