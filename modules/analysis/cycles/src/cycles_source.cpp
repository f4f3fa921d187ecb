#include "scree/cycles/cycles_source.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/signals/time_series.hpp>

namespace scree::cycles {

namespace {

namespace fs = std::filesystem;
using signals::TimeSeries;

const std::vector<std::string> columns_of_lengths = {"length_x", "length_y"};

std::vector<std::string> columns_of(const CyclesRequest& request) {
  std::vector<std::string> columns;
  if (request.strain == CyclesRequest::lengths)
    columns = columns_of_lengths;
  else
    columns = {request.strain};
  if (!request.load.empty()) columns.push_back(request.load);
  return columns;
}

bool has_columns(const fs::path& file, const std::vector<std::string>& columns) {
  const files::CsvRows rows(file);
  return std::all_of(columns.begin(), columns.end(), [&](const std::string& wanted) {
    return std::any_of(rows.columns().begin(), rows.columns().end(), [&](const auto& column) {
      return wanted == column.name || wanted == fmt::format("{} [{}]", column.name, column.unit);
    });
  });
}

bool any_has(const std::vector<fs::path>& series, const std::vector<std::string>& columns) {
  return std::any_of(series.begin(), series.end(),
                     [&](const fs::path& file) { return has_columns(file, columns); });
}

// The series of the probe, else the first with the columns. A single series is taken in any case: its reader
// names the columns that it has.
fs::path series_of_run(const CyclesRequest& request) {
  std::error_code failed;
  if (fs::exists(fs::path(request.directory) / "campaign.json", failed))
    throw Error(fmt::format("{}: is a campaign; give its runs: {}", request.directory,
                            (fs::path(request.directory) / "*/").string()));
  const fs::path folder = fs::path(request.directory) / "series";
  if (!request.probe.empty()) return folder / (request.probe + ".csv");
  std::vector<fs::path> series;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().extension() == ".csv") series.push_back(entry.path());
  if (series.empty())
    throw Error(
        fmt::format("{}: there is no series/*.csv; give the directory of a run with a probe, or --csv FILE",
                    request.directory));
  std::sort(series.begin(), series.end());
  const std::vector<std::string> columns = columns_of(request);
  for (const fs::path& file : series)
    if (has_columns(file, columns)) return file;
  if (request.strain == CyclesRequest::lengths && !any_has(series, columns_of_lengths))
    throw Error(
        folder.string(), "no series has length_x and length_y, from which the strain follows by default",
        "give the scene [[probe]] plugin = \"box\", name the columns of a lid (--strain displacement_lid --load "
        "force_lid), or a column of another strain with --strain");
  if (series.size() == 1) return series[0];
  std::string names;
  for (const std::string& column : columns) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", column);
  throw Error(fmt::format(
      "{}: no series has the columns {}; name one of its columns with --strain, or a series with --probe",
      folder.string(), names));
}

// Drops the rows after the end (s) of the cycles.
void cut(TimeSeries& series, double end) {
  const auto count = std::upper_bound(series.times.begin(), series.times.end(), end) - series.times.begin();
  series.times.resize(std::size_t(count));
  series.values.resize(std::size_t(count));
}

// Strain of lengths x and y, relative to the lengths at a time (s).
TimeSeries strain_of(const TimeSeries& x, const TimeSeries& y, double reference) {
  const auto at = std::lower_bound(x.times.begin(), x.times.end(), reference) - x.times.begin();
  // After the last row too few cycles are left; the classification reports it.
  const std::size_t first = std::size_t(at) < x.times.size() ? std::size_t(at) : 0;
  return {"length_y/length_y0 - length_x/length_x0", "", x.times,
          strain_of_lengths(x.values, y.values, first), x.cut_line};
}

TimeSeries strain_of(const CyclesRequest& request, std::vector<TimeSeries>& columns, double reference) {
  if (request.strain == CyclesRequest::lengths) return strain_of(columns[0], columns[1], reference);
  return std::move(columns[0]);
}

// Each row is a cycle.
CyclesSource rows_as_cycles(const CyclesRequest& request, const fs::path& file,
                            std::vector<TimeSeries> columns) {
  if (!request.load.empty() || request.first_minimum)
    throw Error("--load and --start without a period; give --period");
  const std::vector<double>& times = columns[0].times;
  const double reference =
      request.drop < times.size() ? times[request.drop] : std::numeric_limits<double>::infinity();
  TimeSeries strain = strain_of(request, columns, reference);
  return {
      file, strain.name, strain.unit, "", "", 0, std::move(strain.times), {std::move(strain.values), {}, {}}};
}

CyclesSource by_period(const CyclesRequest& request, const fs::path& file, std::vector<TimeSeries> columns,
                       const LoadTimes& of) {
  constexpr double slack = 1e-6;  // of a period
  const CycleTimes& times = of.times;
  for (TimeSeries& column : columns) cut(column, of.end + slack * times.period);
  const double reference = times.first_minimum + (double(request.drop) - slack) * times.period;
  const TimeSeries load = request.load.empty() ? TimeSeries{} : std::move(columns.back());
  const TimeSeries strain = strain_of(request, columns, reference);
  CyclesSource source{file, strain.name, strain.unit, load.name, load.unit, times.period, {}, {}};
  source.series = cycle_series(strain.times, strain.values, load.values, times);
  for (std::size_t n = 0; n < source.series.strain.size(); ++n)
    source.minimum_times.push_back(times.first_minimum + double(n) * times.period);
  return source;
}

}  // namespace

fs::path series_file(const CyclesRequest& request) {
  if (request.csv.empty()) return series_of_run(request);
  if (request.strain == CyclesRequest::lengths && !has_columns(request.csv, columns_of_lengths))
    throw Error(request.csv, "has no length_x and length_y, from which the strain follows by default",
                "name the column of the strain with --strain");
  return request.csv;
}

CyclesSource read_cycles(const fs::path& file, const CyclesRequest& request,
                         const std::optional<LoadTimes>& load) {
  std::vector<TimeSeries> columns = signals::read_time_series(file, columns_of(request), 2);
  LoadTimes of = load.value_or(LoadTimes{{0, columns[0].times.front()}, std::numeric_limits<double>::max()});
  if (request.period > 0) of.times.period = request.period;
  if (request.first_minimum) of.times.first_minimum = *request.first_minimum;
  try {
    const std::size_t cut_line = columns[0].cut_line;
    CyclesSource source = of.times.period > 0 ? by_period(request, file, std::move(columns), of)
                                              : rows_as_cycles(request, file, std::move(columns));
    source.cut_line = cut_line;
    if (load) source.stage_period = load->times.period;
    return source;
  } catch (const Error& error) {
    throw error.at(file.string());
  }
}

}  // namespace scree::cycles
