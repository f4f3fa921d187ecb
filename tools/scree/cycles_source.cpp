#include "cycles_source.hpp"

#include "run_cycle.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/spectrum/time_series.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;
using spectrum::TimeSeries;

constexpr const char *length_x = "length_x", *length_y = "length_y";

std::vector<std::string> columns_of(const CyclesRequest& request) {
  std::vector<std::string> columns;
  if (request.strain == CyclesRequest::lengths)
    columns = {length_x, length_y};
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

// The series of the probe, or the first with the columns; where none has them, the first, whose reader names what it has.
fs::path series_of_run(const CyclesRequest& request) {
  const fs::path folder = fs::path(request.directory) / "series";
  if (!request.probe.empty()) return folder / (request.probe + ".csv");
  std::error_code failed;
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
  if (series.size() == 1) return series[0];
  std::string names;
  for (const std::string& column : columns) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", column);
  throw Error(fmt::format(
      "{}: no series has the columns {}; name one of its columns with --strain, or a series with --probe",
      folder.string(), names));
}

// Without the rows after the end of the cycles.
TimeSeries read_until(const fs::path& file, const std::string& column, double end) {
  constexpr std::size_t least = 2;
  TimeSeries series = spectrum::read_time_series(file, column, least);
  const auto count = std::upper_bound(series.times.begin(), series.times.end(), end) - series.times.begin();
  series.times.resize(std::size_t(count));
  series.values.resize(std::size_t(count));
  return series;
}

struct Columns {
  TimeSeries strain, load;
};

Columns read_columns(const CyclesRequest& request, const fs::path& file, double end, double reference) {
  Columns columns;
  if (!request.load.empty()) columns.load = read_until(file, request.load, end);
  if (request.strain != CyclesRequest::lengths) {
    columns.strain = read_until(file, request.strain, end);
    return columns;
  }
  const TimeSeries x = read_until(file, length_x, end);
  columns.strain = read_until(file, length_y, end);
  const auto at = std::lower_bound(x.times.begin(), x.times.end(), reference) - x.times.begin();
  // Behind the last row too few cycles are left, which is reported when they are classified.
  const std::size_t first = std::size_t(at) < x.times.size() ? std::size_t(at) : 0;
  columns.strain.values = cycles::strain_of_lengths(x.values, columns.strain.values, first);
  columns.strain.name = "length_y/length_y0 - length_x/length_x0";
  columns.strain.unit.clear();
  return columns;
}

// One row is one cycle.
CyclesSource rows_as_cycles(const CyclesRequest& request, const fs::path& file) {
  if (!request.load.empty() || !std::isnan(request.first_minimum))
    throw Error(fmt::format("{}: --load and --start without a period; give --period", file.string()));
  const TimeSeries time = spectrum::read_time_series(file, columns_of(request)[0], 2);
  const double reference =
      request.drop < time.times.size() ? time.times[request.drop] : std::numeric_limits<double>::infinity();
  TimeSeries strain = read_columns(request, file, time.times.back(), reference).strain;
  return {file, strain.name, strain.unit, "", "", 0, std::move(strain.times), {std::move(strain.values), {}}};
}

CyclesSource by_period(const CyclesRequest& request, const fs::path& file, const cycles::CycleTimes& times,
                       double end) {
  constexpr double slack = 1e-6;  // of a period
  const double reference = times.first_minimum + (double(request.drop) - slack) * times.period;
  const Columns columns = read_columns(request, file, end + slack * times.period, reference);
  CyclesSource source{
      file, columns.strain.name, columns.strain.unit, columns.load.name, columns.load.unit, times.period, {},
      {}};
  source.series =
      cycles::cycle_series(columns.strain.times, columns.strain.values, columns.load.values, times);
  for (std::size_t n = 0; n < source.series.strain.size(); ++n)
    source.minimum_times.push_back(times.first_minimum + double(n) * times.period);
  return source;
}

double first_time(const fs::path& file, const CyclesRequest& request) {
  return spectrum::read_time_series(file, columns_of(request)[0], 2).times.front();
}

}  // namespace

CyclesSource read_cycles(const CyclesRequest& request) {
  const fs::path file = request.csv.empty() ? series_of_run(request) : fs::path(request.csv);
  RunCycles of{{request.period, request.first_minimum}, std::numeric_limits<double>::max()};
  if (request.csv.empty() && !(request.period > 0 && !std::isnan(request.first_minimum)))
    if (const auto found = cycles_of_run(request.directory)) {
      if (!(request.period > 0)) of.times.period = found->times.period;
      if (std::isnan(request.first_minimum)) of.times.first_minimum = found->times.first_minimum;
      of.end = found->end;
    }
  if (!(of.times.period > 0)) return rows_as_cycles(request, file);
  const double begin = first_time(file, request);
  if (std::isnan(of.times.first_minimum)) of.times.first_minimum = begin;
  try {
    return by_period(request, file, of.times, of.end);
  } catch (const Error& error) {
    if (std::string_view(error.what()).starts_with(file.string())) throw;
    throw Error(fmt::format("{}: {}", file.string(), error.what()), error.status());
  }
}

}  // namespace scree::tool
