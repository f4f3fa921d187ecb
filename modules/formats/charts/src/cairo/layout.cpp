#include "layout.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <scree/charts/text_fit.hpp>

namespace scree::charts {
namespace {

using Column = std::vector<double> ChartSeries::*;

// The lowest and the highest of some values.
struct Range {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;

  void add(double value) {
    if (std::isnan(value)) return;
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
};

AxisScale scale_of(const ChartSpec& spec, Column column, bool logarithmic, double pad) {
  Range range;
  for (const ChartSeries& series : spec.series)
    for (const double value : series.*column) range.add(value);
  return {range.lower, range.upper, logarithmic, pad};
}

// That of the values with their bars; a logarithmic axis has no end for bars that reach below 0.
AxisScale y_scale_of(const ChartSpec& spec, double pad) {
  Range range;
  for (const ChartSeries& series : spec.series)
    for (std::size_t k = 0; k < series.y.size(); ++k) {
      const double value = series.y[k], error = series.y_error.empty() ? 0 : series.y_error[k];
      range.add(value);
      if (!std::isfinite(error)) continue;
      range.add(value + error);
      if (!spec.log_y || value > error) range.add(value - error);
    }
  return {range.lower, range.upper, spec.log_y, pad};
}

double widest(const std::vector<std::string>& lines) {
  double width = 0;
  for (const std::string& line : lines) width = std::max(width, text_width(line, label_font));
  return width;
}

// As many ticks as fit side by side with some space between their labels.
Ticks fitting_ticks(const AxisScale& scale, double room) {
  for (int target = 8; target > 2; --target) {
    Ticks ticks = scale.ticks(target);
    if (double(ticks.values.size()) * (widest(ticks.labels) + 1.2 * label_font) < room) return ticks;
  }
  return scale.ticks(2);
}

// Wraps a title at blanks into lines no longer than `room` if possible; the last of four lines has the rest.
std::vector<std::string> wrapped(const std::string& whole, double room) {
  constexpr std::size_t most_lines = 4;
  const std::string text = shown_part(whole);
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (start < text.size()) {
    if (lines.size() + 1 == most_lines) {
      lines.push_back(text.substr(start));
      break;
    }
    std::size_t end = text.find(' ', start);
    for (std::size_t next = end; next != std::string::npos;) {
      next = text.find(' ', next + 1);
      if (text_width(text.substr(start, next - start), title_font, true) > room) break;
      end = next;
    }
    lines.push_back(text.substr(start, end == std::string::npos ? end : end - start));
    start = end == std::string::npos ? text.size() : end + 1;
  }
  return lines;
}

// Of a legend in the font of the labels.
Box legend_size(const ChartSpec& spec) {
  std::vector<std::string> names;
  for (const ChartSeries& series : spec.series) names.push_back(series.name);
  return {0, 0, widest(names) + (legend_sample + 3 * legend_pad) * label_font,
          (legend_line * double(names.size()) + legend_pad) * label_font};
}

// Records which corners of the plot the curves pass through; sizes and positions as fractions of the plot.
class CornerUse {
 public:
  CornerUse(double box_width, double box_height) : box_width_(box_width), box_height_(box_height) {}

  void mark(double x, double y) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const double from_side = is_right(corner) ? 1 - x : x;
      const double from_end = is_top(corner) ? 1 - y : y;
      used_[corner] |= from_side < box_width_ && from_end < box_height_;
    }
  }

  void mark_curve(const ChartSeries& series, const AxisScale& scale_x, const AxisScale& scale_y) {
    if (series.x.empty()) return;
    double x0 = scale_x.position(series.x[0]), y0 = scale_y.position(series.y[0]);
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      const double x1 = scale_x.position(series.x[k]), y1 = scale_y.position(series.y[k]);
      if (std::isnan(x1)) continue;
      const int pieces = 1 + int(100 * std::hypot(x1 - x0, y1 - y0));
      for (int piece = 1; piece <= pieces; ++piece)
        mark(std::lerp(x0, x1, 1.0 * piece / pieces), std::lerp(y0, y1, 1.0 * piece / pieces));
      x0 = x1;
      y0 = y1;
    }
  }

  std::optional<std::size_t> first_free() const {
    const auto free = std::find(used_.begin(), used_.end(), false);
    if (free == used_.end()) return std::nullopt;
    return std::size_t(free - used_.begin());
  }

  static bool is_right(std::size_t corner) { return corner % 2 == 0; }
  static bool is_top(std::size_t corner) { return corner < 2; }

 private:
  double box_width_;
  double box_height_;
  std::array<bool, 4> used_{};
};

// Makes a legend that is higher than the plot smaller.
Legend legend_in(const Box& plot, const ChartSpec& spec) {
  Legend legend{legend_size(spec), label_font};
  const double scale = std::min(1.0, plot.height / legend.box.height);
  legend.box.width *= scale;
  legend.box.height *= scale;
  legend.font *= scale;
  return legend;
}

void place_legend(Layout& layout, const ChartSpec& spec) {
  if (spec.series.size() < 2) return;
  Box& plot = layout.plot;
  Legend legend = legend_in(plot, spec);
  Box& box = legend.box;
  const double gap = 0.6 * label_font;
  CornerUse use((box.width + 1.5 * gap) / plot.width, (box.height + 1.5 * gap) / plot.height);
  for (const ChartSeries& series : spec.series) use.mark_curve(series, layout.x, layout.y);
  if (const auto corner = use.first_free()) {
    box.left = CornerUse::is_right(*corner) ? plot.right() - box.width - gap : plot.left + gap;
    box.top = CornerUse::is_top(*corner) ? plot.top + gap : plot.bottom() - box.height - gap;
  } else {
    box.width = std::min(box.width, 0.4 * chart_width);
    plot.width -= box.width + gap;
    layout.x_ticks = fitting_ticks(layout.x, plot.width);
    box.left = plot.right() + 1.5 * gap;
    box.top = plot.top;
  }
  layout.legend = legend;
}

}  // namespace

Layout Layout::of(const ChartSpec& spec, const std::string& note) {
  const AxisScale x = scale_of(spec, &ChartSeries::x, spec.log_x, 0.02);
  const AxisScale y = y_scale_of(spec, 0.05);
  Layout layout{wrapped(spec.title, chart_width - 4 * label_font), note, x, y, {}, y.ticks(7), {}, {}};
  const double left = 3.2 * label_font + widest(layout.y_ticks.labels);
  const double bottom = 4.0 * label_font;
  const double top = (1.2 + 1.6 * double(layout.title_lines.size()) + (note.empty() ? 0 : 1.3)) * label_font;
  layout.x_ticks = fitting_ticks(x, chart_width - left - label_font);
  const double right = std::max(label_font, 0.5 * label_font + widest(layout.x_ticks.labels) / 2);
  layout.plot = {left, top, chart_width - left - right, chart_height - bottom - top};
  place_legend(layout, spec);
  return layout;
}

}  // namespace scree::charts
