#include "studies/cycles_source.hpp"

#include "studies/run_cycle.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/signals/time_series.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;
using signals::TimeSeries;

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
  if (series.size() == 1) return series[0];
  std::string names;
  for (const std::string& column : columns) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", column);
  throw Error(fmt::format(
      "{}: no series has the columns {}; name one of its columns with --strain, or a series with --probe",
      folder.string(), names));
}

// Without the rows after the end of the cycles.
void cut(TimeSeries& series, double end) {
  const auto count = std::upper_bound(series.times.begin(), series.times.end(), end) - series.times.begin();
  series.times.resize(std::size_t(count));
  series.values.resize(std::size_t(count));
}

// Of lengths x and y; they refer to those at a time.
TimeSeries strain_of(const TimeSeries& x, const TimeSeries& y, double reference) {
  const auto at = std::lower_bound(x.times.begin(), x.times.end(), reference) - x.times.begin();
  // Behind the last row too few cycles are left, which is reported when they are classified.
  const std::size_t first = std::size_t(at) < x.times.size() ? std::size_t(at) : 0;
  return {"length_y/length_y0 - length_x/length_x0", "", x.times,
          cycles::strain_of_lengths(x.values, y.values, first), x.cut_line};
}

// columns: those of the request.
TimeSeries strain_of(const CyclesRequest& request, std::vector<TimeSeries>& columns, double reference) {
  if (request.strain == CyclesRequest::lengths) return strain_of(columns[0], columns[1], reference);
  return std::move(columns[0]);
}

// One row is one cycle.
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
                       const RunCycles& of) {
  constexpr double slack = 1e-6;  // of a period
  const cycles::CycleTimes& times = of.times;
  for (TimeSeries& column : columns) cut(column, of.end + slack * times.period);
  const double reference = times.first_minimum + (double(request.drop) - slack) * times.period;
  const TimeSeries load = request.load.empty() ? TimeSeries{} : std::move(columns.back());
  const TimeSeries strain = strain_of(request, columns, reference);
  CyclesSource source{file, strain.name, strain.unit, load.name, load.unit, times.period, {}, {}};
  source.series = cycles::cycle_series(strain.times, strain.values, load.values, times);
  for (std::size_t n = 0; n < source.series.strain.size(); ++n)
    source.minimum_times.push_back(times.first_minimum + double(n) * times.period);
  return source;
}

// What the request leaves open is that of the run, if the series is of one; of a run whose record is not needed it may be missing.
std::optional<RunCycles> found_for(const CyclesRequest& request) {
  if (!request.csv.empty()) return std::nullopt;
  std::optional<RunCycles> found;
  try {
    found = cycles_of_run(request.directory);
  } catch (const Error&) {
    if (!(request.period > 0 && request.first_minimum)) throw;
  }
  if (found && !(request.period > 0) && !(found->times.period > 0))
    throw Error(fmt::format(
        "{}: the last stage, which was followed, has no period; give that of its load with --period",
        request.directory));
  return found;
}

}  // namespace

CyclesSource read_cycles(const CyclesRequest& request) {
  const fs::path file = request.csv.empty() ? series_of_run(request) : fs::path(request.csv);
  const std::optional<RunCycles> found = found_for(request);
  std::vector<TimeSeries> columns = signals::read_time_series(file, columns_of(request), 2);
  RunCycles of = found.value_or(RunCycles{{0, columns[0].times.front()}, std::numeric_limits<double>::max()});
  if (request.period > 0) of.times.period = request.period;
  if (request.first_minimum) of.times.first_minimum = *request.first_minimum;
  try {
    const std::size_t cut_line = columns[0].cut_line;
    CyclesSource source = of.times.period > 0 ? by_period(request, file, std::move(columns), of)
                                              : rows_as_cycles(request, file, std::move(columns));
    source.cut_line = cut_line;
    if (found) source.stage_period = found->times.period;
    if (request.csv.empty()) source.status = found ? found->status : unfinished_status(request.directory);
    return source;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", file.string(), error.what()), error.status());
  }
}

}  // namespace scree::tool
