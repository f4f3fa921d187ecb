#include "studies/cycles_files.hpp"
#include "studies/cycles_warnings.hpp"
#include "studies/result_paths.hpp"
#include "studies/studies.hpp"
#include "support/verbs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;
using cycles::Class;

struct CyclesArguments {
  std::vector<std::string> directories;
  CyclesRequest request;
  std::uint64_t drop = cycles::ClassOptions{}.drop;
  double round_off = 0;
  std::string touching;
  std::string out;
  bool overwrite = false;
};

CyclesResult analyse(const CyclesArguments& arguments, CyclesRequest request) {
  request.drop = arguments.drop;
  CyclesResult result{
      request.csv.empty() ? request.directory : request.csv, read_cycles(request), {}, arguments.drop, {}};
  for (const std::string& warning : warnings_of_source(result.source))
    report_warning(fmt::format("{}: {}", result.source.file.string(), warning));
  cycles::ClassOptions options;
  options.drop = arguments.drop;
  options.round_off = arguments.round_off;
  try {
    result.found = cycles::classify(result.source.series.strain, options);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", result.source.file.string(), error.what()), error.status());
  }
  if (const std::string warning = warning_of_loads(result.source, result.found, result.drop);
      !warning.empty())
    report_warning(fmt::format("{}: {}", result.source.file.string(), warning));
  if (!arguments.touching.empty())
    result.rattlers = read_rattlers(result.source.file.parent_path() / (arguments.touching + ".csv"),
                                    result.source.minimum_times, arguments.drop);
  return result;
}

std::string outliers_of(const cycles::Classification& c) {
  constexpr std::size_t most = 12;
  if (c.outliers.empty()) return "none";
  const auto end = c.outliers.begin() + std::ptrdiff_t(std::min(most, c.outliers.size()));
  return fmt::format("cycles {}{}", fmt::join(c.outliers.begin(), end, ", "),
                     c.outliers.size() > most ? fmt::format(", ... ({})", c.outliers.size()) : "");
}

// Of the cycles that count.
void print_loops(const CyclesResult& r) {
  const auto& loops = r.source.series.loops;
  if (loops.empty()) return;
  double area = 0, stiffness = 0;
  for (std::size_t n = r.drop; n < loops.size(); ++n) {
    area += loops[n].area / double(loops.size() - r.drop);
    stiffness += loops[n].stiffness / double(loops.size() - r.drop);
  }
  if (std::isnan(area))
    fmt::print("{:<14}no area: fewer than three samples in a cycle\n", "loops");
  else
    fmt::print("{:<14}mean area {:.6g}, stiffness {:.6g}; of the first cycle {:.6g}, {:.6g}\n", "loops", area,
               stiffness, loops[0].area, loops[0].stiffness);
}

// The times before the minima of outliers, or of the other cycles that count, at which a rattler last touched.
std::string touches_of(const CyclesResult& r, bool of_outliers) {
  std::vector<double> before;
  for (std::size_t n = r.drop; n < r.rattlers->touches.size(); ++n)
    if (std::binary_search(r.found.outliers.begin(), r.found.outliers.end(), n) == of_outliers)
      before.push_back(r.rattlers->touches[n].before);
  if (before.empty()) return "none";
  std::sort(before.begin(), before.end());
  return fmt::format("{:.3g} s before the minimum (median of {}; {:.3g} to {:.3g} s)",
                     before[before.size() / 2], before.size(), before.front(), before.back());
}

void print_rattlers(const CyclesResult& r) {
  constexpr std::size_t most = 12;
  std::string names;
  for (const Rattlers::Body& body : r.rattlers->bodies)
    names += fmt::format("{}body {} (touches in {:.2g} % of the observations)", names.empty() ? "" : ", ",
                         body.id, 100 * body.share);
  fmt::print("{:<14}{}\n", "rattlers", names.empty() ? "none" : names);
  if (r.rattlers->touches.empty()) return;
  fmt::print("{:<14}outliers: {}\n", "last touch", touches_of(r, true));
  fmt::print("{:<14}other cycles: {}\n", "", touches_of(r, false));
  for (std::size_t k = 0; k < std::min(most, r.found.outliers.size()); ++k) {
    const LatestTouch& touch = r.rattlers->touches[r.found.outliers[k]];
    fmt::print("{:<14}cycle {}: body {} {:.3g} s before its minimum\n", "", r.found.outliers[k], touch.body,
               touch.before);
  }
}

void print_summary(const CyclesResult& r) {
  const cycles::Classification& c = r.found;
  const std::string period = r.source.period > 0 ? fmt::format("of {:.10g} s ", r.source.period) : "";
  fmt::print("{}: {}, {} {}from {:.10g} s, {} dropped\n", files::escaped(r.source.file.string()),
             files::one_line(r.source.strain), counted(r.source.series.strain.size() - 1, "cycle"), period,
             r.source.minimum_times.front(), r.drop);
  fmt::print("{:<14}{:.4e} ± {:.1e} per cycle; of the median {:.4e}\n", "slope", c.line.slope,
             c.line.slope_error, c.robust.slope);
  fmt::print("{:<14}{:.3e} rms from the straight line, {} the slope per cycle\n", "deviation", c.line.rms,
             c.line.ratchets() ? "below" : "not below");
  fmt::print("{:<14}{:.3e}\n", "range", c.range);
  fmt::print("{:<14}{}\n", "outliers", outliers_of(c));
  print_loops(r);
  if (r.rattlers) print_rattlers(r);
  fmt::print("{:<14}{}: {}\n", "class", cycles::class_name(c.kind), c.reason);
}

void print_line(const CyclesResult& r, std::size_t width) {
  fmt::print("{:<{}}  {:<15}  slope {:>11.3e}  rms {:>9.2e}  range {:>9.2e}  outliers {}\n",
             files::escaped(r.name), width, cycles::class_name(r.found.kind), r.found.line.slope,
             r.found.line.rms, r.found.range, r.found.outliers.size());
}

void print_counts(const std::vector<CyclesResult>& results) {
  std::array<std::size_t, cycles::classes> counts{};
  std::size_t up = 0;
  double logarithms = 0;
  for (const CyclesResult& r : results) {
    ++counts[std::size_t(r.found.kind)];
    if (r.found.kind != Class::ratcheting) continue;
    up += r.found.line.slope > 0;
    logarithms += std::log(std::abs(r.found.line.slope));
  }
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k)
    text += fmt::format("{}{} {}", k > 0 ? ", " : "", counts[k], cycles::class_name(Class(k)));
  fmt::print("{}: {}\n", counted(results.size(), "run"), text);
  const std::size_t ratcheting = counts[std::size_t(Class::ratcheting)];
  if (ratcheting > 0)
    fmt::print("ratcheting: geometric mean of |slope| {:.4e} per cycle; {} with slopes above 0, {} below\n",
               std::exp(logarithms / double(ratcheting)), up, ratcheting - up);
}

ExitStatus analyse_one(const CyclesArguments& a, const CyclesRequest& request) {
  const CyclesResult result = analyse(a, request);
  const fs::path folder = !a.out.empty()        ? fs::path(a.out)
                          : request.csv.empty() ? fs::path(request.directory)
                                                : fs::path(request.csv).parent_path();
  const CyclesFiles files(folder, result.source.file, a.overwrite);
  print_summary(result);
  files.write(result);
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
    if (!directories.insert(resolved(request.directory)).second)
      throw Error(fmt::format("{} is given twice; give each run once", directory));
    results.push_back(analyse(a, request));
    width = std::max(width, results.back().name.size());
  }
  const VerdictsFile file(a.out, results, a.overwrite);
  for (const CyclesResult& r : results) print_line(r, width);
  print_counts(results);
  file.write(results);
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
