#include "common_sections.hpp"
#include "figures.hpp"
#include "html.hpp"
#include "numbers.hpp"
#include "scene_charts.hpp"
#include "text_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <scree/report/record.hpp>
#include <scree/report/result_tables.hpp>

// The page of a spectrum.
namespace scree::report {

namespace {

using charts::ChartSeries;
using charts::LineStyle;

bool is_sweep(const std::string& method) { return method.starts_with("sweep"); }

// As in the charts of the study: sweeps are marks, below the lines; pulses beside others are dashed.
ChartSeries curve_of(const std::string& method, bool beside_others) {
  ChartSeries curve;
  curve.name = method == "sweep_down" ? "sweep down" : method;
  if (is_sweep(method)) curve.line = LineStyle::none, curve.markers = true;
  if (method == "pulse" && beside_others) curve.line = LineStyle::dashed;
  return curve;
}

// The methods of a table, sweeps first.
std::vector<std::string> methods_of(const TextTable& table) {
  std::vector<std::string> methods;
  for (std::size_t k = 0; k < table.rows(); ++k)
    if (const std::string& method = table.text(k, "method");
        std::find(methods.begin(), methods.end(), method) == methods.end())
      methods.push_back(method);
  std::stable_partition(methods.begin(), methods.end(), is_sweep);
  return methods;
}

double highest_frequency(const TextTable& table) {
  double highest = 0;
  for (std::size_t k = 0; k < table.rows(); ++k) highest = std::fmax(highest, table.number(k, "frequency"));
  return highest;
}

// The row of a method whose frequency is the nearest.
std::optional<std::size_t> nearest_row(const TextTable& table, const std::string& method, double frequency) {
  std::optional<std::size_t> nearest;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const auto distance = [&](std::size_t row) {
      return std::abs(table.number(row, "frequency") - frequency);
    };
    if (table.text(k, "method") == method && (!nearest || distance(k) < distance(*nearest))) nearest = k;
  }
  return nearest;
}

// The peaks of a column by the method that is first in the table, as points of its curve.
ChartSeries peaks_of(const TextTable& table, const TextTable& peaks, const std::string& column,
                     double scale) {
  ChartSeries marks = {"peaks", {}, {}, std::array<double, 3>{0.1, 0.1, 0.1}, LineStyle::none, true};
  for (std::size_t k = 0; k < peaks.rows(); ++k) {
    const std::string& method = peaks.text(0, "method");
    if (peaks.text(k, "column") != column || peaks.text(k, "method") != method) continue;
    if (const auto row = nearest_row(table, method, peaks.number(k, "frequency"))) {
      marks.x.push_back(scale * table.number(*row, "frequency"));
      marks.y.push_back(table.number(*row, column + ".amplitude"));
    }
  }
  return marks;
}

charts::ChartSpec chart_of(const TextTable& table, const TextTable& peaks, const std::string& column,
                           const std::string& unit) {
  const bool in_khz = highest_frequency(table) >= 1e4;
  const double scale = in_khz ? 1e-3 : 1;
  charts::ChartSpec chart;
  chart.title = column + " over the frequency of the drive";
  chart.x_label = in_khz ? "frequency (kHz)" : "frequency (Hz)";
  chart.y_label =
      unit.empty() || unit == "1" ? column + " per drive" : fmt::format("{} per drive ({})", column, unit);
  chart.log_y = true;
  const std::vector<std::string> methods = methods_of(table);
  for (const std::string& method : methods) {
    ChartSeries curve = curve_of(method, methods.size() > 1);
    for (std::size_t k = 0; k < table.rows(); ++k) {
      const double amplitude = table.number(k, column + ".amplitude");
      if (table.text(k, "method") != method || !(amplitude > 0)) continue;
      curve.x.push_back(scale * table.number(k, "frequency"));
      curve.y.push_back(amplitude);
    }
    if (!curve.x.empty()) chart.series.push_back(std::move(curve));
  }
  if (ChartSeries marks = peaks_of(table, peaks, column, scale); !marks.x.empty())
    chart.series.push_back(std::move(marks));
  return chart;
}

void add_spectra(const Results& results, const TextTable& peaks, Figures& figures) {
  constexpr std::string_view ending = ".amplitude";
  const TextTable table(results.directory / "spectrum.csv");
  for (const auto& column : table.columns())
    if (column.name.ends_with(ending) && column.name.size() > ending.size())
      figures.add_chart(
          chart_of(table, peaks, column.name.substr(0, column.name.size() - ending.size()), column.unit));
}

std::string peak_table(const TextTable& peaks) {
  Table table({{"method"},
               {"column"},
               {"frequency (Hz)", true},
               {"width (Hz)", true},
               {"quality", true},
               {"amplitude", true},
               {"wavelengths", true},
               {"to the first method (Hz)", true}});
  const auto both = [&](std::size_t k, const std::string& name) {
    return with_error(peaks.number(k, name), peaks.number(k, name + "_error"));
  };
  for (std::size_t k = 0; k < peaks.rows(); ++k) {
    const std::string& unit = peaks.text(k, "amplitude_unit");
    table.add({escaped(peaks.text(k, "method")), code(peaks.text(k, "column")), both(k, "frequency"),
               both(k, "width"), both(k, "quality"),
               both(k, "amplitude") + (unit == "1" ? "" : " " + escaped(unit)),
               number_text(peaks.number(k, "wavelengths")), number_text(peaks.number(k, "difference"), 3)});
  }
  return section("Peaks", table.html("peaks.csv"));
}

std::string method_table(const Json& record) {
  Table table({{"method"}, {"frequencies", true}, {"steps", true}, {"wall time", true}, {"notes"}});
  for (const Json& method : list_in(record, "methods")) {
    std::string notes;
    for (const Json& note : list_in(method, "notes"))
      if (note.is_string()) notes += (notes.empty() ? "" : "<br>") + escaped(note.get<std::string>());
    table.add({escaped(text_in(method, "method")), count_text(number_in(method, "frequencies")),
               count_text(number_in(method, "steps")), duration_text(number_in(method, "wall_s")), notes});
  }
  return section("Methods", table.html());
}

}  // namespace

std::string spectrum_sections(const Results& results) {
  const TextTable peaks(results.directory / "peaks.csv");
  Figures figures;
  add_spectra(results, peaks, figures);
  Columns columns(tables_in(results.directory));
  add_scene_charts(results, columns, figures);
  return verdict(results) + section("Spectra", figures.html()) + peak_table(peaks) +
         method_table(results.record) + expectations(results) + warnings(results) + repetition(results);
}

}  // namespace scree::report
