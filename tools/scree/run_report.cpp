#include "run_report.hpp"

#include "support/progress_bar.hpp"
#include "support/verbs.hpp"
#include "support/verdict_report.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/step_check.hpp>

namespace scree::tool {

namespace {

void print_carried(const Simulation& simulation) {
  const Footprint f = simulation.footprint();
  fmt::print("{}, {} degrees of freedom; {} bytes per body, {} bytes per pair\n",
             run::describe_bodies(simulation), f.degrees_of_freedom, f.bytes_per_body, f.bytes_per_pair);
  fmt::print("{}\n", run::describe_step(simulation));
  if (simulation.steps() > 0)
    fmt::print("goes on from t = {:g} s, after {}\n", simulation.time(), counted(simulation.steps(), "step"));
  if (!simulation.taken_over().empty())
    fmt::print("taken over: {}\n",
               files::escaped(fmt::format("{}", fmt::join(simulation.taken_over(), ", "))));
}

double quantity_of(const run::RunResult& r, const char* name) {
  for (const auto& [key, value] : r.quantities)
    if (key == name) return value;
  return 0;
}

void print_result(const run::RunResult& r) {
  const auto quantity = [&](const char* name) { return quantity_of(r, name); };
  fmt::print("{} in {:.3g} s, {:.3g} million particle-steps per second; {:.3g} s for output\n",
             counted(std::size_t(quantity("steps")), "step"), r.wall_time - r.output,
             1e-6 * r.particle_steps_per_second, r.output);
  if (const double residual = quantity("energy_residual"); !std::isnan(residual))
    fmt::print("energy residual {:.2g} of the turnover, ", residual);
  fmt::print("momentum residual {:.2g}, largest overlap {:.3g} of the radius\n",
             quantity("momentum_residual"), quantity("max_overlap_ratio"));
  fmt::print("state hash {:016x}\n", r.state_hash);
}

// What a folder of results holds: "12 files"; empty if it is not there.
std::string content_of(const std::filesystem::path& path) {
  std::error_code failed;
  if (!std::filesystem::is_directory(path, failed)) return "";
  const auto count = std::distance(std::filesystem::directory_iterator(path, failed), {});
  return ", " + counted(std::size_t(count), "file");
}

void print_places(const std::filesystem::path& directory, bool quiet) {
  fmt::print("results in {}\n", files::escaped(directory.string()));
  if (quiet) return;
  for (const auto& [name, what] :
       {std::pair{"report.html", "all that follows on one page"},
        {"series", "time series (CSV)"},
        {"snapshots", "ParaView files (.vtp, .pvd)"},
        {"images", "pictures (PNG)"},
        {"film.mp4", "the pictures as a film"},
        {"charts", "charts"},
        {"fields", "density, momentum and stress (.vti, .pvd, .csv)"},
        {"final_packing.csv", "bodies at the end, for the key file of [particles]"},
        {"final_state.h5", "the whole state at the end"},
        {"checkpoint", "states for scree resume"},
        {"scenario.toml", "the scenario with its overrides"},
        {"run.json", "summary of the run"}})
    if (const std::filesystem::path path = directory / name; std::filesystem::exists(path))
      fmt::print("  {:<28} {}{}\n", path.string(), what, content_of(path));
}

run::RunOptions reporting_options(ProgressBar& bar, bool quiet) {
  run::RunOptions options;
  options.stop = &watch_for_interrupt();
  if (!quiet) options.on_start = print_carried;
  options.on_progress = [&bar](const run::Progress& p) { bar.show(p); };
  options.on_warning = [&bar](const std::string& line) {
    bar.clear();
    report_warning(line);
  };
  return options;
}

}  // namespace

run::RunResult with_progress(bool quiet, const std::function<run::RunResult(run::RunOptions)>& work) {
  ProgressBar bar(quiet);
  return work(reporting_options(bar, quiet));
}

void print_sources(const scenario::Plan& plan) {
  for (const scenario::BodySource& source : plan.body_sources)
    fmt::print("  {}\n", files::escaped(source.text()));
}

ExitStatus report_run(const run::RunResult& result, bool quiet) {
  if (!quiet) print_result(result);
  const bool met = report_verdicts(result.verdicts, quiet);
  if (result.interrupted)
    fmt::print("interrupted; results so far are saved, go on with: scree resume {}\n",
               result.directory.string());
  print_places(result.directory, quiet);
  if (result.interrupted) return ExitStatus::interrupted;
  return met ? ExitStatus::success : ExitStatus::failure;
}

}  // namespace scree::tool
