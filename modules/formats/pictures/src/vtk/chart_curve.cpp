#include "chart_curve.hpp"

#include <algorithm>
#include <cmath>

#include <vtkPlotPoints.h>

namespace scree::pictures {
namespace {

// Blue, vermilion, green, purple, orange, sky blue, black: distinct for colour-blind readers and in grey.
constexpr std::array<double, 3> color_cycle[] = {{0.00, 0.45, 0.70}, {0.84, 0.37, 0.00}, {0.00, 0.62, 0.45},
                                                 {0.80, 0.47, 0.65}, {0.90, 0.62, 0.00}, {0.34, 0.71, 0.91},
                                                 {0.00, 0.00, 0.00}};
// Of curves whose colours are those of others.
constexpr LineStyle line_cycle[] = {LineStyle::solid, LineStyle::dashed, LineStyle::dotted,
                                    LineStyle::dash_dotted};
constexpr int marker_cycle[] = {vtkPlotPoints::CIRCLE, vtkPlotPoints::SQUARE, vtkPlotPoints::DIAMOND};

// Splits a curve into its dashes.
class Dasher {
 public:
  // Lengths of a dash, a gap, a dash and so on, of which the last is followed by the first.
  explicit Dasher(std::vector<double> lengths) : lengths_(std::move(lengths)) {}

  void advance(double x0, double y0, double x1, double y1) {
    const double length = std::hypot(x1 - x0, y1 - y0);
    double done = 0;
    while (done < length) {
      const double step = std::min(length - done, lengths_[part_] - phase_);
      if (part_ % 2 == 0)
        for (double at : {done, done + step}) {
          pieces_.push_back(float(std::lerp(x0, x1, at / length)));
          pieces_.push_back(float(std::lerp(y0, y1, at / length)));
        }
      done += step;
      phase_ += step;
      // Rounding must not cause an endless loop.
      if (phase_ >= lengths_[part_] * (1 - 1e-9)) phase_ = 0, part_ = (part_ + 1) % lengths_.size();
    }
  }

  // A point without neighbours.
  void dot(double x, double y, double size) { advance(x - size / 2, y, x + size / 2, y); }

  std::vector<float> take() { return std::move(pieces_); }

 private:
  std::vector<double> lengths_;
  std::size_t part_ = 0;
  double phase_ = 0;  // within the part
  std::vector<float> pieces_;
};

std::vector<double> dashes_of(LineStyle style, double font) {
  const double dash = 0.7 * font, gap = 0.35 * font, dot = 0.13 * font, short_gap = 0.27 * font,
               endless = 1e9;
  switch (style) {
    case LineStyle::dashed:
      return {dash, gap};
    case LineStyle::dotted:
      return {dot, short_gap};
    case LineStyle::dash_dotted:
      return {dash, short_gap, dot, short_gap};
    default:
      return {endless, 0};
  }
}

}  // namespace

CurveStyle CurveStyle::of(const ChartSeries& series, std::size_t index, double font) {
  const std::size_t round = series.color ? 0 : index / std::size(color_cycle);
  const LineStyle own =
      series.line == LineStyle::solid ? line_cycle[round % std::size(line_cycle)] : series.line;
  const LineStyle line = series.x.size() != 1 ? own : LineStyle::none;
  const bool markers = series.markers || line == LineStyle::none;
  return {series.color.value_or(color_cycle[index % std::size(color_cycle)]), line,
          markers ? marker_cycle[index % std::size(marker_cycle)] : vtkPlotPoints::NONE, font / 9,
          0.5 * font};
}

std::vector<float> line_pieces(const std::vector<double>& x, const std::vector<double>& y, LineStyle style,
                               double font) {
  if (style == LineStyle::none) return {};
  Dasher dasher(dashes_of(style, font));
  const auto is_point = [&](std::size_t k) { return k < x.size() && !std::isnan(x[k]); };
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!is_point(k)) continue;
    if (is_point(k + 1))
      dasher.advance(x[k], y[k], x[k + 1], y[k + 1]);
    else if (k > 0 && !is_point(k - 1))
      dasher.dot(x[k], y[k], font / 9);
  }
  return dasher.take();
}

}  // namespace scree::pictures
