#include "studies/spectrum_files.hpp"

#include "support/verbs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <scree/files/csv_line.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/snapshot/load_backend.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

std::string table_of(const spectrum::AmplitudeSpectrum& amplitudes, const std::string& unit) {
  std::string text = files::csv_line(
      {"frequency [Hz]", unit.empty() ? "amplitude" : fmt::format("amplitude [{}]", files::one_line(unit))});
  for (std::size_t k = 0; k < amplitudes.amplitude.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{},{}\n", files::csv_number(amplitudes.frequency(k)),
                   files::csv_number(amplitudes.amplitude[k]));
  return text;
}

// The largest amplitude in each of some thousand steps of the logarithmic axis, about one per pixel.
snapshot::ChartSeries curve_of(const spectrum::AmplitudeSpectrum& amplitudes) {
  constexpr double steps_per_decade = 400;
  snapshot::ChartSeries curve{"amplitude", {}, {}};
  double step = -1;
  for (std::size_t k = 1; k < amplitudes.amplitude.size(); ++k) {
    const double amplitude = amplitudes.amplitude[k];
    if (!(amplitude > 0)) continue;  // not possible on a logarithmic axis
    if (const double now = std::floor(steps_per_decade * std::log10(double(k)));
        curve.x.empty() || now > step) {
      step = now;
      curve.x.push_back(amplitudes.frequency(k));
      curve.y.push_back(amplitude);
    } else if (amplitude > curve.y.back()) {
      curve.x.back() = amplitudes.frequency(k);
      curve.y.back() = amplitude;
    }
  }
  return curve;
}

}  // namespace

SpectrumFiles::SpectrumFiles(fs::path folder, const fs::path& source)
    : folder_(std::move(folder)), source_(source) {
  std::error_code failed;
  if (fs::equivalent(folder_ / table_name, source_, failed))
    throw Error(fmt::format("{}: the spectrum would replace this file; give another directory with --out",
                            source_.string()));
}

void SpectrumFiles::write(const spectrum::AmplitudeSpectrum& amplitudes,
                          const spectrum::TimeSeries& series) const {
  std::error_code failed;
  if (!folder_.empty()) fs::create_directories(folder_, failed);
  if (failed)
    throw Error(
        fmt::format("{}: cannot be created ({}); give another --out", folder_.string(), failed.message()));
  const fs::path table = folder_ / table_name, picture = folder_ / chart_name;
  files::write_atomically(table, table_of(amplitudes, series.unit));
  fmt::print("{}\n", table.string());
  if (!snapshot::has_pictures()) {
    report(fmt::format("{}, so there is no chart; {}", snapshot::no_pictures, snapshot::no_pictures_cure),
           ExitStatus::success);
    return;
  }
  snapshot::ChartSpec chart;
  chart.title = files::one_line(series.name);
  chart.x_label = "frequency (Hz)";
  chart.y_label =
      series.unit.empty() ? "amplitude" : fmt::format("amplitude ({})", files::one_line(series.unit));
  chart.y_label += ", the largest per pixel";
  chart.log_x = chart.log_y = true;
  chart.series.push_back(curve_of(amplitudes));
  if (chart.series[0].x.empty()) return;  // a constant
  snapshot::load_backend()->chart(chart, picture);
  fmt::print("{}\n", picture.string());
}

}  // namespace scree::tool
