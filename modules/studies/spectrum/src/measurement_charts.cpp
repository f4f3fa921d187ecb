#include "measurement_files.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include <fmt/format.h>

#include <scree/charts/draw_chart.hpp>

namespace scree::spectrum {

namespace {

constexpr std::size_t most_peaks = 6;  // of a chart

bool is_sweep(const MethodSpectrum& spectrum) { return spectrum.method.starts_with("sweep"); }

// In a chart with other methods, pulses are dashed lines over those below them.
charts::ChartSeries curve_of(const MethodSpectrum& spectrum, std::size_t c, double scale,
                             bool beside_others) {
  charts::ChartSeries curve;
  curve.name = spectrum.method == "sweep_down" ? "sweep down" : spectrum.method;
  if (spectrum.method == "pulse" && beside_others) curve.line = charts::LineStyle::dashed;
  if (is_sweep(spectrum)) curve.line = charts::LineStyle::none, curve.markers = true;
  for (std::size_t k = 0; k < spectrum.frequencies.size(); ++k) {
    const double amplitude = std::abs(spectrum.columns[c].response[k]);
    if (!(amplitude > 0 && std::isfinite(amplitude))) continue;  // not possible on a logarithmic axis
    curve.x.push_back(scale * spectrum.frequencies[k]);
    curve.y.push_back(amplitude);
  }
  return curve;
}

bool is_named(const Peak& r) { return !name_of(r).empty(); }

// Shapes of the peaks of the first method and column that have any with a name.
void draw_shapes(const Measurement& m, const run::RunDirectory& directory) {
  charts::ChartSpec chart;
  chart.title = m.title + ": shapes of the peaks";
  chart.x_label = "layer, in the order of the probe";
  chart.y_label = "displacement over the largest";
  const Peak& first = *std::find_if(m.peaks.begin(), m.peaks.end(), is_named);
  for (const Peak& r : m.peaks) {
    if (r.spectrum != first.spectrum || r.column != first.column || !is_named(r)) continue;
    if (chart.series.size() == most_peaks) break;
    charts::ChartSeries curve;
    curve.name = fmt::format("{}, {:.4g} kHz", name_of(r), 1e-3 * r.mode.frequency);
    for (std::size_t k = 0; k < r.shape.size(); ++k) curve.x.push_back(double(k + 1));
    curve.y = r.shape;
    curve.markers = true;
    chart.series.push_back(std::move(curve));
  }
  charts::draw_chart(chart, directory.add("charts/shapes.png"));
}

// The named peaks of a column, by the first method that has any, as points of its curve.
void add_peaks(const Measurement& m, std::size_t c, double scale, charts::ChartSpec& chart) {
  const auto first = std::find_if(m.peaks.begin(), m.peaks.end(),
                                  [&](const Peak& r) { return r.column == c && is_named(r); });
  const std::size_t most = chart.series.size() + most_peaks;
  for (auto r = first; r != m.peaks.end() && chart.series.size() < most; ++r) {
    if (r->column != c || r->spectrum != first->spectrum || !is_largest_of_name(m, *r)) continue;
    const MethodSpectrum& spectrum = m.spectra[r->spectrum];
    const double frequency = r->mode.frequency;
    charts::ChartSeries point;
    point.name = fmt::format("{}, {:.5g} {}", name_of(*r), scale * frequency, scale < 1 ? "kHz" : "Hz");
    point.x = {scale * spectrum.frequencies[*r->maximum]};
    point.y = {std::abs(spectrum.columns[c].response[*r->maximum])};
    point.line = charts::LineStyle::none, point.markers = true;
    chart.series.push_back(std::move(point));
  }
}

// The curves of all methods of a column.
void draw_curves(const Measurement& m, std::size_t c, const run::RunDirectory& directory) {
  double highest = 0;
  for (const MethodSpectrum& spectrum : m.spectra)
    if (!spectrum.frequencies.empty()) highest = std::max(highest, spectrum.frequencies.back());
  const bool in_khz = highest >= 1e4;
  charts::ChartSpec chart;
  chart.title = m.title;
  chart.x_label = in_khz ? "frequency (kHz)" : "frequency (Hz)";
  const std::string unit = unit_of_response(m.observed[c]);
  chart.y_label = unit == "1" ? m.observed[c].name + " per drive"
                              : fmt::format("{} per drive ({})", m.observed[c].name, unit);
  chart.log_y = true;
  // The marks of sweeps are below the lines.
  for (const bool sweeps : {true, false})
    for (const MethodSpectrum& spectrum : m.spectra)
      if (charts::ChartSeries curve = curve_of(spectrum, c, in_khz ? 1e-3 : 1, m.spectra.size() > 1);
          is_sweep(spectrum) == sweeps && !curve.x.empty())
        chart.series.push_back(std::move(curve));
  if (chart.series.empty()) return;
  add_peaks(m, c, in_khz ? 1e-3 : 1, chart);
  std::string name = m.observed[c].name;
  name[name.rfind('.')] = '_';
  charts::draw_chart(chart, directory.add("charts/" + name + ".png"));
}

}  // namespace

void draw_charts(const Measurement& m, const run::RunDirectory& directory,
                 const std::function<void(const std::string&)>& report) {
  const auto draw = [&](const std::string& name, const auto& chart) {
    try {
      chart();
    } catch (const std::exception& error) {
      report(fmt::format("chart '{}' was not drawn: {}", name, error.what()));
    }
  };
  if (std::any_of(m.peaks.begin(), m.peaks.end(), is_named))
    draw("shapes", [&] { draw_shapes(m, directory); });
  for (std::size_t c = 0; c < responding(m.observed); ++c)
    draw(m.observed[c].name, [&] { draw_curves(m, c, directory); });
}

}  // namespace scree::spectrum
