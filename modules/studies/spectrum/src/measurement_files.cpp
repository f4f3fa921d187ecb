#include "measurement_files.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/files/csv_line.hpp>
#include <scree/run/verdict.hpp>

namespace scree::spectrum {

namespace {

using files::csv_line;
using files::csv_number;
using Json = nlohmann::ordered_json;
using Cells = std::vector<std::string>;

void add_numbers(Cells& cells, std::initializer_list<double> numbers) {
  for (const double x : numbers) cells.push_back(csv_number(x));
}

std::string spectrum_table(const Measurement& m) {
  Cells head = {"method", "frequency [Hz]"};
  const std::size_t columns = responding(m.observed);
  for (std::size_t c = 0; c < columns; ++c)
    for (const char* what : {"amplitude", "phase", "error", "linearity"})
      head.push_back(fmt::format("{}.{} [{}]", m.observed[c].name, what,
                                 what == std::string("phase") ? "rad" : unit_of_response(m.observed[c])));
  std::string text = csv_line(head);
  for (const MethodSpectrum& spectrum : m.spectra)
    for (std::size_t k = 0; k < spectrum.frequencies.size(); ++k) {
      Cells cells = {spectrum.method, csv_number(spectrum.frequencies[k])};
      for (std::size_t c = 0; c < columns; ++c) {
        const MethodSpectrum::Column& column = spectrum.columns[c];
        add_numbers(cells, {std::abs(column.response[k]), std::arg(column.response[k]), column.error[k],
                            column.linearity.empty() ? NAN : column.linearity[k]});
      }
      text += csv_line(cells);
    }
  return text;
}

std::string peak_table(const Measurement& m) {
  std::string text = csv_line({"method", "column", "frequency [Hz]", "frequency_error [Hz]", "width [Hz]",
                               "width_error [Hz]", "quality", "quality_error", "amplitude", "amplitude_error",
                               "amplitude_unit", "phase [rad]", "difference [Hz]", "wavelengths"});
  for (const Peak& r : m.peaks) {
    const signals::FittedMode& mode = r.mode;
    Cells cells = {m.spectra[r.spectrum].method, m.observed[r.column].name};
    add_numbers(cells, {mode.frequency, mode.frequency_error, mode.width, mode.width_error, mode.quality,
                        mode.quality_error, mode.amplitude, mode.amplitude_error});
    cells.push_back(unit_of_response(m.observed[r.column]));
    add_numbers(cells, {mode.phase, r.difference, r.wavelengths});
    text += csv_line(cells);
  }
  return text;
}

// By method, column and name, so that several packings can be compared:
// peaks.linear.strain.strain.3λ/4.frequency. A peak without a name has its number:
// peaks.pulse.strain.strain.peak_1.frequency.
Json peaks_of(const Measurement& m) {
  Json peaks = Json::object();
  for (const Peak& r : m.peaks) {
    Json& of_column = peaks[m.spectra[r.spectrum].method][m.observed[r.column].name];
    Json& peak =
        of_column[is_largest_of_name(m, r) ? name_of(r) : fmt::format("peak_{}", of_column.size() + 1)];
    for (std::size_t k = 0; k < peak_numbers.size(); ++k)
      if (const double x = number_of(r, k); !std::isnan(x)) peak[peak_numbers[k]] = x;
    if (const std::string name = name_of(r); !name.empty()) peak["name"] = name;
  }
  return peaks;
}

std::string shape_table(const Measurement& m) {
  std::string text = csv_line({"method", "column", "frequency [Hz]", "wavelengths", "layer", "displacement",
                               "amplitude [m/m]", "phase [rad]"});
  for (const Peak& r : m.peaks)
    for (std::size_t k = 0; k < r.shape.size(); ++k)
      text += csv_line({m.spectra[r.spectrum].method, m.observed[r.column].name, csv_number(r.mode.frequency),
                        csv_number(r.wavelengths), fmt::format("{}", k + 1), csv_number(r.shape[k]),
                        csv_number(std::abs(r.layers[k])), csv_number(std::arg(r.layers[k]))});
  return text;
}

bool has_shapes(const Measurement& m) {
  return std::any_of(m.peaks.begin(), m.peaks.end(), [](const Peak& r) { return !r.shape.empty(); });
}

std::string method_table(const Measurement& m) {
  std::string text = csv_line({"method", "frequencies", "steps", "wall [s]"});
  for (const MethodSpectrum& spectrum : m.spectra)
    text += csv_line({spectrum.method, fmt::format("{}", spectrum.frequencies.size()),
                      fmt::format("{}", spectrum.steps), csv_number(spectrum.wall_time)});
  return text;
}

}  // namespace

// Whether a peak has a name that no larger one of the same method and column has.
bool is_largest_of_name(const Measurement& m, const Peak& peak) {
  return !name_of(peak).empty() && std::none_of(m.peaks.begin(), m.peaks.end(), [&](const Peak& r) {
    return r.spectrum == peak.spectrum && r.column == peak.column && name_of(r) == name_of(peak) &&
           r.mode.amplitude > peak.mode.amplitude;
  });
}

std::string unit_of_response(const ObservedColumn& column) {
  if (column.relative || column.unit.empty()) return "1/m";
  return column.unit == "m" ? "1" : column.unit + "/m";
}

Json record_of(const Measurement& m) {
  Json json = {{"title", m.title}};
  for (const ObservedColumn& column : m.observed) json["observed"].push_back(column.name);
  for (const MethodSpectrum& spectrum : m.spectra)
    json["methods"].push_back({{"method", spectrum.method},
                               {"frequencies", spectrum.frequencies.size()},
                               {"steps", spectrum.steps},
                               {"wall_s", spectrum.wall_time},
                               {"notes", spectrum.notes}});
  json["peaks"] = peaks_of(m);
  json["expect"] = run::json_of(m.verdicts);
  return json;
}

std::string sweep_table(const std::vector<ObservedColumn>& observed, const std::vector<SweepPoint>& points) {
  Cells head = {"frequency [Hz]", "start [s]", "steps", "periods", "steady", "drive [m]"};
  const std::size_t columns = responding(observed);
  for (std::size_t c = 0; c < columns; ++c) {
    const ObservedColumn& column = observed[c];
    const std::string unit = unit_of_response(column);
    head.push_back(fmt::format("{}.amplitude [{}]", column.name, unit));
    head.push_back(fmt::format("{}.phase [rad]", column.name));
    head.push_back(fmt::format("{}.error [{}]", column.name, unit));
    head.push_back(column.unit.empty() ? column.name + ".mean"
                                       : fmt::format("{}.mean [{}]", column.name, column.unit));
  }
  std::string text = csv_line(head);
  for (const SweepPoint& point : points) {
    Cells cells = {csv_number(point.frequency), csv_number(point.start),     fmt::format("{}", point.steps),
                   csv_number(point.periods),   point.is_steady ? "1" : "0", csv_number(point.drive)};
    for (std::size_t c = 0; c < columns; ++c) {
      const SweepPoint::Column& column = point.columns[c];
      add_numbers(cells, {std::abs(column.response), std::arg(column.response), column.error, column.mean});
    }
    text += csv_line(cells);
  }
  return text;
}

void write_tables(const Measurement& m, const run::RunDirectory& directory) {
  directory.write_file("spectrum.csv", spectrum_table(m));
  directory.write_file("peaks.csv", peak_table(m));
  directory.write_file("methods.csv", method_table(m));
  if (has_shapes(m)) directory.write_file("shapes.csv", shape_table(m));
}

}  // namespace scree::spectrum
