#include "drawing.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scree::charts {
namespace {

constexpr double thin = label_font / 20, thick = label_font / 14;  // (pixels) grid, axes
constexpr double tick_length = 0.35 * label_font, minor_tick_length = 0.2 * label_font;

void set_grey(cairo_t* cairo, double white) { cairo_set_source_rgb(cairo, white, white, white); }

void add_line(cairo_t* cairo, const Point& from, const Point& to) {
  cairo_move_to(cairo, from.x, from.y);
  cairo_line_to(cairo, to.x, to.y);
}

void draw_grid(cairo_t* cairo, const Layout& layout) {
  const Box& plot = layout.plot;
  for (const double value : layout.x_ticks.values) {
    const double x = plot.left + layout.x.position(value) * plot.width;
    add_line(cairo, {x, plot.top}, {x, plot.bottom()});
  }
  for (const double value : layout.y_ticks.values) {
    const double y = plot.bottom() - layout.y.position(value) * plot.height;
    add_line(cairo, {plot.left, y}, {plot.right(), y});
  }
  cairo_set_line_width(cairo, thin);
  set_grey(cairo, 0.88);
  cairo_stroke(cairo);
}

void add_ticks(cairo_t* cairo, const Layout& layout, const std::vector<double>& x_values,
               const std::vector<double>& y_values, double length) {
  const Box& plot = layout.plot;
  for (const double value : x_values) {
    const double x = plot.left + layout.x.position(value) * plot.width;
    add_line(cairo, {x, plot.bottom()}, {x, plot.bottom() + length});
  }
  for (const double value : y_values) {
    const double y = plot.bottom() - layout.y.position(value) * plot.height;
    add_line(cairo, {plot.left, y}, {plot.left - length, y});
  }
}

void draw_axes(cairo_t* cairo, const Layout& layout) {
  const Box& plot = layout.plot;
  cairo_rectangle(cairo, plot.left, plot.top, plot.width, plot.height);
  add_ticks(cairo, layout, layout.x_ticks.values, layout.y_ticks.values, tick_length);
  add_ticks(cairo, layout, layout.x.minor_ticks(), layout.y.minor_ticks(), minor_tick_length);
  cairo_set_line_width(cairo, thick);
  set_grey(cairo, 0.1);
  cairo_stroke(cairo);
  for (std::size_t k = 0; k < layout.x_ticks.values.size(); ++k)
    draw_text(cairo, plot.left + layout.x.position(layout.x_ticks.values[k]) * plot.width,
              plot.bottom() + label_font, layout.x_ticks.labels[k], {label_font, Align::center}, plot.width);
  for (std::size_t k = 0; k < layout.y_ticks.values.size(); ++k)
    draw_text(cairo, plot.left - 0.6 * label_font,
              plot.bottom() - layout.y.position(layout.y_ticks.values[k]) * plot.height,
              layout.y_ticks.labels[k], {label_font, Align::right}, plot.left);
}

// Bars of the errors, which end at the lower edge where a logarithmic axis has no place for their end.
void draw_error_bars(cairo_t* cairo, const Layout& layout, const ChartSeries& series,
                     const CurveStyle& style) {
  constexpr double cap = 0.25 * label_font;
  for (std::size_t k = 0; k < series.y_error.size(); ++k) {
    const double value = series.y[k], error = series.y_error[k];
    if (!(error > 0) || !std::isfinite(error) || std::isnan(value)) continue;
    const Point top = layout.place(series.x[k], value + error);
    Point bottom = layout.place(series.x[k], value - error);
    const bool ends = std::isfinite(bottom.y);
    if (!ends) bottom.y = layout.plot.bottom();
    add_line(cairo, top, bottom);
    add_line(cairo, {top.x - cap, top.y}, {top.x + cap, top.y});
    if (ends) add_line(cairo, {bottom.x - cap, bottom.y}, {bottom.x + cap, bottom.y});
  }
  cairo_set_source_rgb(cairo, style.color[0], style.color[1], style.color[2]);
  cairo_set_line_width(cairo, thick);
  cairo_stroke(cairo);
}

// The middle of a label in the middle of the plot, or as near to it as there is room in the picture.
double middle_of_label(const std::string& label, double size, double middle_of_plot,
                       double length_of_picture) {
  const double half = std::min(text_width(label, size), length_of_picture - 2 * label_font) / 2 + label_font;
  return std::clamp(middle_of_plot, half, length_of_picture - half);
}

void draw_labels(cairo_t* cairo, const ChartSpec& spec, const Layout& layout) {
  constexpr double room = chart_width - 2 * label_font;
  const Box& plot = layout.plot;
  double y = 1.3 * label_font;
  for (const std::string& line : layout.title_lines) {
    draw_text(cairo, chart_width / 2, y, line, {title_font, Align::center, true}, room);
    y += 1.6 * label_font;
  }
  draw_text(cairo, chart_width / 2, y - 0.15 * label_font, layout.note, {0.9 * label_font, Align::center},
            room);
  const double size = 1.1 * label_font;
  draw_text(cairo, middle_of_label(spec.x_label, size, plot.left + plot.width / 2, chart_width),
            chart_height - 1.1 * label_font, spec.x_label, {size, Align::center}, room);
  draw_text(cairo, 1.2 * label_font,
            middle_of_label(spec.y_label, size, plot.top + plot.height / 2, chart_height), spec.y_label,
            {size, Align::center, false, true}, chart_height - 2 * label_font);
}

void draw_legend(cairo_t* cairo, const ChartSpec& spec, const Legend& legend) {
  const Box& box = legend.box;
  cairo_rectangle(cairo, box.left, box.top, box.width, box.height);
  set_grey(cairo, 1);
  cairo_fill_preserve(cairo);
  cairo_set_line_width(cairo, thin);
  set_grey(cairo, 0.6);
  cairo_stroke(cairo);
  const double left = box.left + legend_pad * legend.font, right = left + legend_sample * legend.font;
  const double name = right + legend_pad * legend.font;
  double y = box.top + (legend_pad + legend_line) / 2 * legend.font;
  for (std::size_t row = 0; row < spec.series.size(); ++row, y += legend_line * legend.font) {
    CurveStyle style = CurveStyle::of(spec.series[row], row);
    const Marker marker = std::exchange(style.marker, Marker::none);
    draw_curve(cairo, {{left, y}, {right, y}}, style, legend.font);
    style.line = LineStyle::none;
    style.marker = marker;
    draw_curve(cairo, {{(left + right) / 2, y}}, style, legend.font);
    draw_text(cairo, name, y, spec.series[row].name, {legend.font},
              box.right() - name - legend_pad * legend.font);
  }
}

}  // namespace

void draw(cairo_t* cairo, const ChartSpec& spec, const Layout& layout) {
  set_grey(cairo, 1);
  cairo_paint(cairo);
  draw_grid(cairo, layout);
  draw_axes(cairo, layout);
  for (std::size_t k = 0; k < spec.series.size(); ++k) {
    const ChartSeries& series = spec.series[k];
    std::vector<Point> points;
    for (std::size_t i = 0; i < series.x.size(); ++i)
      points.push_back(layout.place(series.x[i], series.y[i]));
    draw_error_bars(cairo, layout, series, CurveStyle::of(series, k));
    draw_curve(cairo, points, CurveStyle::of(series, k), label_font);
  }
  draw_labels(cairo, spec, layout);
  if (layout.legend) draw_legend(cairo, spec, *layout.legend);
}

}  // namespace scree::charts
