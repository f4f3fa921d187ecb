#include "curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace scree::charts {
namespace {

// Blue, vermilion, green, purple, orange, sky blue, black: distinct for colour-blind readers and in grey.
constexpr std::array<double, 3> color_cycle[] = {{0.00, 0.45, 0.70}, {0.84, 0.37, 0.00}, {0.00, 0.62, 0.45},
                                                 {0.80, 0.47, 0.65}, {0.90, 0.62, 0.00}, {0.34, 0.71, 0.91},
                                                 {0.00, 0.00, 0.00}};
// Of curves whose colours are those of others.
constexpr LineStyle line_cycle[] = {LineStyle::solid, LineStyle::dashed, LineStyle::dotted,
                                    LineStyle::dash_dotted};
constexpr Marker marker_cycle[] = {Marker::circle, Marker::square, Marker::diamond};

bool is_gap(const Point& point) { return std::isnan(point.x); }

// Lengths of a dash, a gap, a dash and so on; none of a solid line.
std::vector<double> dashes_of(LineStyle style, double font) {
  const double dash = 0.7 * font, gap = 0.35 * font, dot = 0.13 * font, short_gap = 0.27 * font;
  switch (style) {
    case LineStyle::dashed:
      return {dash, gap};
    case LineStyle::dotted:
      return {dot, short_gap};
    case LineStyle::dash_dotted:
      return {dash, short_gap, dot, short_gap};
    default:
      return {};
  }
}

void fill_circle(cairo_t* cairo, const Point& at, double radius) {
  cairo_arc(cairo, at.x, at.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(cairo);
}

void draw_line(cairo_t* cairo, const std::vector<Point>& line, LineStyle style, double font) {
  const double width = font / 9;
  const auto is_gap_at = [&](std::size_t k) { return k >= line.size() || is_gap(line[k]); };
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (is_gap(line[k])) continue;
    const bool begins = k == 0 || is_gap(line[k - 1]);
    if (begins && is_gap_at(k + 1)) fill_circle(cairo, line[k], width / 2);
  }
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (is_gap(line[k])) continue;
    if (k == 0 || is_gap(line[k - 1]))
      cairo_move_to(cairo, line[k].x, line[k].y);
    else
      cairo_line_to(cairo, line[k].x, line[k].y);
  }
  const std::vector<double> dashes = dashes_of(style, font);
  cairo_set_dash(cairo, dashes.data(), int(dashes.size()), 0);
  cairo_set_line_width(cairo, width);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo, dashes.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_stroke(cairo);
}

void draw_marker(cairo_t* cairo, const Point& at, Marker marker, double size) {
  const double half = size / 2, side = 0.9 * half, tip = 1.2 * half;
  if (marker == Marker::circle) return fill_circle(cairo, at, half);
  if (marker == Marker::square) cairo_rectangle(cairo, at.x - side, at.y - side, 2 * side, 2 * side);
  if (marker == Marker::diamond) {
    cairo_move_to(cairo, at.x - tip, at.y);
    cairo_line_to(cairo, at.x, at.y - tip);
    cairo_line_to(cairo, at.x + tip, at.y);
    cairo_line_to(cairo, at.x, at.y + tip);
  }
  cairo_fill(cairo);
}

void draw_markers(cairo_t* cairo, const std::vector<Point>& points, Marker marker, double size) {
  constexpr double unseen = 0.25;  // pixels from the one before
  const Point* before = nullptr;
  for (const Point& point : points) {
    if (is_gap(point)) continue;
    if (before && std::hypot(point.x - before->x, point.y - before->y) < unseen) continue;
    draw_marker(cairo, point, marker, size);
    before = &point;
  }
}

}  // namespace

CurveStyle CurveStyle::of(const ChartSeries& series, std::size_t index) {
  const std::size_t round = series.color ? 0 : index / std::size(color_cycle);
  const LineStyle own =
      series.line == LineStyle::solid ? line_cycle[round % std::size(line_cycle)] : series.line;
  const LineStyle line = series.x.size() != 1 ? own : LineStyle::none;
  const bool markers = series.markers || line == LineStyle::none;
  return {series.color.value_or(color_cycle[index % std::size(color_cycle)]), line,
          markers ? marker_cycle[index % std::size(marker_cycle)] : Marker::none};
}

std::vector<Point> thinned(const std::vector<Point>& line) {
  const auto column = [](const Point& point) { return std::floor(2 * point.x); };
  const auto is_higher = [](const Point& a, const Point& b) { return a.y < b.y; };
  std::vector<Point> kept;
  for (auto first = line.begin(); first != line.end();) {
    const auto end = std::find_if(std::next(first), line.end(),
                                  [&](const Point& point) { return column(point) != column(*first); });
    const auto [high, low] = std::minmax_element(first, end, is_higher);
    std::array seen = {first, std::min(high, low), std::max(high, low), std::prev(end)};
    for (auto at = seen.begin(), last = std::unique(seen.begin(), seen.end()); at != last; ++at)
      kept.push_back(**at);
    first = end;
  }
  return kept;
}

void draw_curve(cairo_t* cairo, const std::vector<Point>& points, const CurveStyle& style, double font) {
  cairo_save(cairo);
  cairo_set_source_rgb(cairo, style.color[0], style.color[1], style.color[2]);
  if (style.line != LineStyle::none) draw_line(cairo, thinned(points), style.line, font);
  if (style.marker != Marker::none) draw_markers(cairo, points, style.marker, 0.5 * font);
  cairo_restore(cairo);
}

}  // namespace scree::charts
