#include "chart_curve.hpp"

#include <algorithm>
#include <cmath>

#include <vtkPlotPoints.h>

namespace scree::snapshot {
namespace {

// Blue, vermilion, green, purple, orange, sky blue, black: distinct for colour-blind readers and in grey.
constexpr std::array<double, 3> color_cycle[] = {{0.00, 0.45, 0.70}, {0.84, 0.37, 0.00}, {0.00, 0.62, 0.45},
                                                 {0.80, 0.47, 0.65}, {0.90, 0.62, 0.00}, {0.34, 0.71, 0.91},
                                                 {0.00, 0.00, 0.00}};
constexpr int marker_cycle[] = {vtkPlotPoints::CIRCLE, vtkPlotPoints::SQUARE, vtkPlotPoints::DIAMOND};

// Splits a curve into its dashes.
class Dasher {
 public:
  Dasher(double on, double off) : on_(on), period_(on + off) {}

  void advance(double x0, double y0, double x1, double y1) {
    const double length = std::hypot(x1 - x0, y1 - y0);
    double done = 0;
    while (done < length) {
      const bool drawn = phase_ < on_;
      const double step = std::min(length - done, (drawn ? on_ : period_) - phase_);
      if (drawn)
        for (double at : {done, done + step}) {
          pieces_.push_back(float(std::lerp(x0, x1, at / length)));
          pieces_.push_back(float(std::lerp(y0, y1, at / length)));
        }
      done += step;
      phase_ += step;
      if (phase_ >= period_ * (1 - 1e-9)) phase_ = 0;
      if (step <= 1e-9 * period_) phase_ = drawn ? on_ : 0;  // rounding must not cause an endless loop
    }
  }

  std::vector<float> take() { return std::move(pieces_); }

 private:
  double on_;
  double period_;
  double phase_ = 0;
  std::vector<float> pieces_;
};

}  // namespace

CurveStyle CurveStyle::of(const ChartSeries& series, std::size_t index, double font) {
  const LineStyle line = series.x.size() > 1 ? series.line : LineStyle::none;
  const bool markers = series.markers || line == LineStyle::none;
  return {series.color.value_or(color_cycle[index % std::size(color_cycle)]), line,
          markers ? marker_cycle[index % std::size(marker_cycle)] : vtkPlotPoints::NONE, font / 9,
          0.5 * font};
}

std::vector<float> line_pieces(const std::vector<double>& x, const std::vector<double>& y, LineStyle style,
                               double font) {
  if (style == LineStyle::none) return {};
  const double endless = 1e9;
  Dasher dasher = style == LineStyle::dashed   ? Dasher(0.7 * font, 0.35 * font)
                  : style == LineStyle::dotted ? Dasher(0.13 * font, 0.27 * font)
                                               : Dasher(endless, 0);
  for (std::size_t k = 1; k < x.size(); ++k) dasher.advance(x[k - 1], y[k - 1], x[k], y[k]);
  return dasher.take();
}

}  // namespace scree::snapshot
