#include "studies/analysis_folder.hpp"
#include "studies/cycles_report.hpp"
#include "studies/studies.hpp"
#include "support/cycles_arguments.hpp"
#include "support/verbs.hpp"

#include <algorithm>
#include <memory>
#include <set>

#include <fmt/format.h>

#include <scree/charts/draw_chart.hpp>
#include <scree/cycles/result_files.hpp>
#include <scree/cycles/warnings.hpp>
#include <scree/files/paths.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/recorded_load.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;
using cycles::CyclesRequest, cycles::CyclesResult;

CyclesRequest request_of(const CyclesArguments& a) {
  CyclesRequest request;
  request.csv = a.csv;
  request.probe = a.probe;
  if (!a.strain.empty()) request.strain = a.strain;
  request.load = a.load;
  request.period = a.period;
  request.first_minimum = a.first_minimum;
  return request;
}

// The load of the run, for what the request leaves open. The record may be missing if nothing is.
std::optional<run::RecordedLoad> load_of(const CyclesRequest& request) {
  std::optional<run::RecordedLoad> load;
  try {
    load = run::recorded_load(request.directory);
  } catch (const Error&) {
    if (!(request.period > 0 && request.first_minimum)) throw;
  }
  if (load && !(request.period > 0) && !(load->period > 0))
    throw Error(fmt::format(
        "{}: the last stage, which was followed, has no period; give that of its load with --period",
        request.directory));
  return load;
}

cycles::CyclesSource read_source(const CyclesRequest& request) {
  const fs::path file = cycles::series_file(request);
  if (!request.csv.empty()) return cycles::read_cycles(file, request, std::nullopt);
  const std::optional<run::RecordedLoad> load = load_of(request);
  std::optional<cycles::LoadTimes> times;
  if (load) times = cycles::LoadTimes{{load->period, load->start}, load->end};
  cycles::CyclesSource source = cycles::read_cycles(file, request, times);
  source.status = load ? load->status : run::unfinished_status(request.directory);
  return source;
}

cycles::Classification classify(const CyclesArguments& arguments, const cycles::CyclesSource& source) {
  cycles::ClassOptions options;
  options.drop = arguments.drop;
  options.round_off = arguments.round_off;
  try {
    return cycles::classify(source.series.strain, options);
  } catch (const Error& error) {
    throw error.at(source.file.string());
  }
}

CyclesResult analyse(const CyclesArguments& arguments, CyclesRequest request) {
  request.drop = arguments.drop;
  CyclesResult result{
      request.csv.empty() ? request.directory : request.csv, read_source(request), {}, arguments.drop, {}};
  const auto warn = [&](const std::string& warning) {
    report_warning(fmt::format("{}: {}", result.source.file.string(), warning));
  };
  for (const std::string& warning : cycles::warnings_of_source(result.source)) warn(warning);
  result.found = classify(arguments, result.source);
  if (const std::string warning = cycles::warning_of_loads(result.source, result.found, result.drop);
      !warning.empty())
    warn(warning);
  if (!arguments.touching.empty())
    result.rattlers = cycles::read_rattlers(result.source.file.parent_path() / (arguments.touching + ".csv"),
                                            result.source.minimum_times, arguments.drop);
  return result;
}

// Writes the table, the record and the chart, and prints their names.
void write_files(const AnalysisFolder& folder, const CyclesResult& result) {
  const fs::path table = folder.path_of(cycles::table_name), record = folder.path_of(cycles::record_name);
  files::write_atomically(table, cycles::cycles_table(result));
  files::write_atomically(record, cycles::cycles_record(result, folder.path()));
  fmt::print("{}\n{}\n", table.string(), record.string());
  const fs::path chart = folder.path_of(cycles::chart_name);
  charts::draw_chart(cycles::cycles_chart(result), chart);
  fmt::print("{}\n", chart.string());
}

ExitStatus analyse_one(const CyclesArguments& a, const CyclesRequest& request) {
  const CyclesResult result = analyse(a, request);
  const fs::path folder = !a.out.empty()        ? fs::path(a.out)
                          : request.csv.empty() ? fs::path(request.directory)
                                                : fs::path(request.csv).parent_path();
  const AnalysisFolder results(folder, result.source.file, "the cycles",
                               {cycles::table_name, cycles::record_name, cycles::chart_name});
  results.create();
  if (!a.overwrite) results.refuse_others(cycles::series_of_record(folder / cycles::record_name));
  print_summary(result);
  write_files(results, result);
  return ExitStatus::success;
}

std::string without_slash(std::string directory) {
  while (directory.size() > 1 && directory.back() == '/') directory.pop_back();
  return directory;
}

ExitStatus analyse_all(const CyclesArguments& a) {
  std::vector<CyclesResult> results;
  std::set<fs::path> directories;
  std::size_t width = 0;
  for (const std::string& directory : a.directories) {
    CyclesRequest request = request_of(a);
    request.directory = without_slash(directory);
    if (!directories.insert(files::resolved(request.directory)).second)
      throw Error(fmt::format("{} is given twice; give each run once", directory));
    results.push_back(analyse(a, request));
    width = std::max(width, results.back().name.size());
  }
  create_folder(a.out);
  const fs::path file = fs::path(a.out) / cycles::verdicts_name;
  std::error_code failed;
  if (!a.overwrite && fs::exists(file, failed)) cycles::check_verdicts(file, results);
  for (const CyclesResult& r : results) print_line(r, width);
  print_counts(results);
  files::write_atomically(file, cycles::verdicts_table(results, a.out));
  fmt::print("{}\n", file.string());
  return ExitStatus::success;
}

ExitStatus cycles_of(const CyclesArguments& a) {
  const bool of_file = !a.csv.empty();
  if (of_file && (!a.directories.empty() || !a.probe.empty()))
    throw Error("--csv analyses a file, not runs and their probes; give one of them");
  if (!of_file && a.directories.empty())
    throw Error("neither a run directory nor --csv; give the directories of runs, or --csv FILE");
  if (a.directories.size() > 1) return analyse_all(a);
  CyclesRequest request = request_of(a);
  if (!of_file) request.directory = a.directories[0];
  return analyse_one(a, request);
}

}  // namespace

void add_cycles_verb(CommandLine& line) {
  auto a = std::make_shared<CyclesArguments>();
  Verb verb = add_cycles_options(line, *a);
  verb.action([a] { return cycles_of(*a); });
}

}  // namespace scree::tool
