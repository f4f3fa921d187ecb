#include "scene_charts.hpp"

#include "html.hpp"
#include "numbers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/charts/scaled_unit.hpp>
#include <scree/document/document.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/report/record.hpp>
#include <scree/report/result_tables.hpp>

namespace scree::report {

namespace fs = std::filesystem;

namespace {

void read_rows(files::CsvRows& rows, std::vector<std::vector<double>>& values) {
  try {
    while (rows.next() && rows.is_whole() && rows.row().size() == values.size())
      for (std::size_t k = 0; k < values.size(); ++k) values[k].push_back(parsed(rows.row()[k].text));
  } catch (const Error&) {
    // The line that a run is about to write.
  }
}

}  // namespace

const Columns::Table& Columns::read(const std::string& name) {
  constexpr std::uintmax_t largest = 256u << 20;  // (bytes)
  if (const auto found = read_.find(name); found != read_.end()) return found->second;
  Table& table = read_[name];
  const auto file = tables_.find(name);
  if (file == tables_.end()) return table;
  std::error_code failed;
  if (fs::file_size(file->second, failed) > largest && !failed)
    throw Error(file->second.filename().string(), "has more than 256 MB", "draw it with scree chart");
  files::CsvRows rows(file->second);
  std::vector<std::vector<double>> values(rows.columns().size());
  const std::vector<files::CsvRows::Column> header = rows.columns();
  read_rows(rows, values);
  for (std::size_t k = 0; k < header.size(); ++k) table.emplace(header[k].name, std::move(values[k]));
  return table;
}

const std::vector<double>& Columns::of(const std::string& table, const std::string& column) {
  static const std::vector<double> none;
  const Table& columns = read(table);
  const auto found = columns.find(column);
  return found == columns.end() ? none : found->second;
}

const std::vector<scenario::ProbeColumns>& Columns::tables() {
  if (columns_.empty())
    for (const auto& table : tables_) {
      try {
        const auto one = columns_of({table});
        columns_.insert(columns_.end(), one.begin(), one.end());
      } catch (const Error&) {
        // A table without a header.
      }
    }
  return columns_;
}

namespace {

std::vector<scenario::ChartPlan> planned_charts(const Results& results, Columns& columns) {
  const std::string text = text_in(results.record, "scenario");
  if (text.find("chart") == text.npos) return {};
  return scenario::read_charts(document::Document::parse(text, "scenario").root(), columns.tables());
}

}  // namespace

bool add_scene_charts(const Results& results, Columns& columns, Figures& figures) {
  std::vector<scenario::ChartPlan> plans;
  try {
    plans = planned_charts(results, columns);
  } catch (const Error& error) {  // a table is missing, or the record was edited
    figures.add_line(escaped(fmt::format("The charts of the scene are not drawn: {}", error.what())));
    return true;
  }
  for (const scenario::ChartPlan& plan : plans) {
    try {
      figures.add_chart(scenario::chart_of(
          plan, [&](const std::string& probe, const std::string& name) { return columns.of(probe, name); }));
    } catch (const Error& error) {
      figures.add_line(escaped(fmt::format("The chart '{}' is not drawn: {}", plan.title, error.what())));
    }
  }
  return !plans.empty();
}

namespace {

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

// The columns of a probe of energies, largest first, as far as they can be told from 0 beside the largest.
std::vector<std::string> energies_of(const scenario::ProbeColumns& probe, Columns& columns) {
  constexpr std::size_t most = 6;
  constexpr double visible = 5e-3;
  std::vector<std::pair<double, std::string>> energies;
  for (std::size_t k = 0; k < probe.names.size(); ++k)
    if (probe.units[k] == "J")
      energies.emplace_back(largest_of(columns.of(probe.probe, probe.names[k])), probe.names[k]);
  std::stable_sort(energies.begin(), energies.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> names;
  for (const auto& [size, name] : energies)
    if (names.size() < most && size > visible * energies.front().first) names.push_back(name);
  return names;
}

// Less is no curve, and very short runs are not to wait for cairo, which takes longer than they do.
constexpr std::size_t fewest_samples = 8;

bool records_energies(const scenario::ProbeColumns& probe) {
  const auto has = [&](const char* name) {
    return std::find(probe.names.begin(), probe.names.end(), name) != probe.names.end();
  };
  return has("kinetic_translation") && has("residual");
}

}  // namespace

void add_energy_chart(Columns& columns, Figures& figures) {
  const auto& tables = columns.tables();
  const auto probe = std::find_if(tables.begin(), tables.end(), records_energies);
  if (probe == tables.end() || columns.of(probe->probe, "time").size() < fewest_samples) return;
  const std::vector<std::string> names = energies_of(*probe, columns);
  if (names.empty()) return;
  const charts::ScaledUnit unit = charts::scaled_unit(largest_of(columns.of(probe->probe, names[0])), "J");
  const std::vector<double>& times = columns.of(probe->probe, "time");
  const charts::ScaledUnit time = charts::scaled_unit(largest_of(times), "s");
  charts::ChartSpec chart;
  chart.title = "Energies over time";
  chart.x_label = fmt::format("time ({})", time.symbol);
  chart.y_label = fmt::format("energy ({})", unit.symbol);
  for (const std::string& name : names) {
    charts::ChartSeries curve = {name, times, columns.of(probe->probe, name)};
    for (double& value : curve.x) value *= time.factor;
    for (double& value : curve.y) value *= unit.factor;
    std::replace(curve.name.begin(), curve.name.end(), '_', ' ');
    chart.series.push_back(std::move(curve));
  }
  figures.add_chart(std::move(chart));
}

}  // namespace scree::report
