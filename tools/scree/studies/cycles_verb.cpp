#include "studies/analysis_folder.hpp"
#include "studies/cycles_report.hpp"
#include "studies/studies.hpp"
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

struct CyclesArguments {
  std::vector<std::string> directories;
  CyclesRequest request;
  std::uint64_t drop = cycles::ClassOptions{}.drop;
  double round_off = 0;
  std::string touching;
  std::string out;
  bool overwrite = false;
};

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
    throw Error(fmt::format("{}: {}", source.file.string(), error.what()), error.status());
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
    CyclesRequest request = a.request;
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
  const bool of_file = !a.request.csv.empty();
  if (of_file && (!a.directories.empty() || !a.request.probe.empty()))
    throw Error("--csv analyses a file, not runs and their probes; give one of them");
  if (!of_file && a.directories.empty())
    throw Error("neither a run directory nor --csv; give the directories of runs, or --csv FILE");
  if (a.directories.size() > 1) return analyse_all(a);
  CyclesRequest request = a.request;
  if (!of_file) request.directory = a.directories[0];
  return analyse_one(a, request);
}

}  // namespace

void add_cycles_verb(CommandLine& line) {
  Verb verb = add_study_verb(line, "cycles");
  auto a = std::make_shared<CyclesArguments>();
  verb.option("directories", a->directories, "Directories of runs; several give a table of verdicts");
  verb.option("--csv", a->request.csv, "Instead of runs: CSV file; its first column is the time in s")
      .shown_as("FILE");
  verb.option("--probe", a->request.probe,
              "Probe of the runs; default: the first whose series has the columns")
      .shown_as("NAME");
  verb.option(
          "--touching", a->touching,
          "Probe of the kind touching, beside the series: names rattlers and their touches before outliers")
      .shown_as("NAME");
  verb.option("--strain", a->request.strain,
              "Column, or lengths: length_y/length_y0 - length_x/length_x0, which is the default")
      .shown_as("NAME");
  verb.option("--load", a->request.load, "Column of the load, for areas and stiffnesses of the loops")
      .shown_as("NAME");
  verb.option(
          "--period", a->request.period,
          "Period of the load (s); default: that of the last stage that has one, else one row is one cycle")
      .above_zero()
      .shown_as("T");
  verb.option(
          "--start", a->request.first_minimum,
          "Time of the first minimum of the load (s); default: the beginning of that stage, or the first row")
      .finite()
      .shown_as("TIME");
  verb.option("--drop", a->drop, "Cycles before the first that counts (default 29)").between(0, 1e9);
  verb.option("--round-off", a->round_off,
              "Largest range of a constant strain, and least deviation of an outlier (default 1e-13)")
      .above_zero();
  verb.option(
          "--out", a->out,
          "Directory of the results; default that of the run or the CSV file, for several runs the current one")
      .shown_as("DIR");
  verb.flag("--overwrite", a->overwrite, "Replace results of other series and runs in the directory");
  verb.footer(
      "Ratcheting: the root mean square deviation from a straight line is below its slope per cycle (McNamara et al. 2008).\n"
      "Shakedown goes to a limit, creep does not; settling: the strain per cycle falls, and the cycles do not tell which.\n"
      "Example: scree cycles runs/biaxial\n"
      "         scree cycles campaigns/laws/*/ --out campaigns/laws\n"
      "         scree cycles --csv box.csv --strain deviatoric_strain --load deviatoric_stress --period 10 --drop 5");
  verb.action([a] { return cycles_of(*a); });
}

}  // namespace scree::tool
