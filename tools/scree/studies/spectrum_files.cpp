#include "studies/spectrum_files.hpp"

#include "support/verbs.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include <scree/charts/draw_chart.hpp>
#include <scree/files/csv_line.hpp>
#include <scree/files/paths.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view of_series = "# series: ";

// The series that a table of lines names, relative to its folder; empty if there is no such table.
fs::path series_of_lines(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || !line.starts_with(of_series)) return {};
  return files::resolved(file.parent_path() / line.substr(of_series.size()));
}

// Numbers that a line does not have are left empty.
std::string lines_of(const std::vector<signals::FoundLine>& lines, const std::string& unit,
                     const std::string& series) {
  std::string text = fmt::format("{}{}\n", of_series, series);
  text += files::csv_line({"frequency [Hz]", "frequency_error [Hz]", signals::with_unit("amplitude", unit),
                           signals::with_unit("amplitude_error", unit), "phase [rad]", "phase_error [rad]",
                           "quality", "quality_error"});
  const auto unless_zero = [](double number) { return number == 0 ? "" : files::csv_number(number); };
  for (const signals::FoundLine& line : lines)
    text += files::csv_line({files::csv_number(line.frequency), unless_zero(line.frequency_error),
                             files::csv_number(line.amplitude), files::csv_number(line.amplitude_error),
                             files::csv_number(line.phase), files::csv_number(line.phase_error),
                             unless_zero(line.quality), unless_zero(line.quality_error)});
  return text;
}

std::string table_of(const signals::AmplitudeSpectrum& amplitudes, const std::string& unit) {
  std::string text = files::csv_line({"frequency [Hz]", signals::with_unit("amplitude", unit)});
  for (std::size_t k = 0; k < amplitudes.amplitude.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{},{}\n", files::csv_number(amplitudes.frequency(k)),
                   files::csv_number(amplitudes.amplitude[k]));
  return text;
}

// The largest amplitude in each step of the logarithmic axis, about one step per pixel.
charts::ChartSeries curve_of(const signals::AmplitudeSpectrum& amplitudes) {
  constexpr double steps_per_decade = 400;
  charts::ChartSeries curve{"amplitude", {}, {}};
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

SpectrumFiles::SpectrumFiles(fs::path folder, const fs::path& source, bool overwrite)
    : folder_(std::move(folder), source, "the spectrum", {table_name, lines_name, chart_name}),
      source_(source) {
  if (!overwrite) folder_.refuse_others(series_of_lines(folder_.path() / lines_name));
}

void SpectrumFiles::write(const signals::AmplitudeSpectrum& amplitudes, const signals::TimeSeries& series,
                          const std::vector<signals::FoundLine>& lines) const {
  folder_.create();
  const fs::path table = folder_.path_of(table_name), of_lines = folder_.path_of(lines_name);
  files::write_atomically(of_lines,
                          lines_of(lines, series.unit, files::relative_to(folder_.path(), source_)));
  files::write_atomically(table, table_of(amplitudes, series.unit));
  fmt::print("{}\n{}\n", table.string(), of_lines.string());
  charts::ChartSpec chart;
  chart.title = files::one_line(series.name);
  chart.x_label = "frequency (Hz)";
  chart.y_label =
      series.unit.empty() ? "amplitude" : fmt::format("amplitude ({})", files::one_line(series.unit));
  chart.y_label += ", the largest per pixel";
  chart.log_x = chart.log_y = true;
  chart.series.push_back(curve_of(amplitudes));
  if (chart.series[0].x.empty()) return;  // a constant
  const fs::path picture = folder_.path_of(chart_name);
  charts::draw_chart(chart, picture);
  fmt::print("{}\n", picture.string());
}

}  // namespace scree::tool
