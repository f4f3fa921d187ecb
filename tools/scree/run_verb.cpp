#include "progress_bar.hpp"
#include "verbs.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/run/run.hpp>
#include <scree/run/set_up.hpp>

namespace scree::tool {

namespace {

struct RunArguments {
  std::string scenario, out;
  std::vector<std::string> overrides;
  unsigned threads = 1;
  bool overwrite = false, quiet = false;
  PluginOptions plugins;
};

void print_carried(const Simulation& simulation) {
  const Footprint f = simulation.footprint();
  fmt::print("{} bodies in {}D, {} degrees of freedom; {} bytes per body, {} bytes per pair\n",
             simulation.particles().size(), simulation.dimension(), f.degrees_of_freedom, f.bytes_per_body,
             f.bytes_per_pair);
  fmt::print("{}\n", run::describe_step(simulation));
}

double quantity_of(const run::RunResult& r, const char* name) {
  for (const auto& [key, value] : r.quantities)
    if (key == name) return value;
  return 0;
}

void print_result(const run::RunResult& r) {
  const auto quantity = [&](const char* name) { return quantity_of(r, name); };
  fmt::print("{} steps in {:.3g} s, {:.3g} million particle-steps per second; {:.3g} s for output\n",
             quantity("steps"), r.wall - r.output, 1e-6 * r.particle_steps_per_second, r.output);
  fmt::print(
      "energy residual {:.2g} of the turnover, momentum residual {:.2g}, largest overlap {:.3g} of the "
      "radius\n",
      quantity("energy_residual"), quantity("momentum_residual"), quantity("max_overlap_ratio"));
  fmt::print("state hash {:016x}\n", r.state_hash);
  for (const run::Verdict& v : r.verdicts)
    if (v.met)
      fmt::print("met      {} ({} = {:.6g})\n", files::escaped(v.expectation.requirement),
                 v.expectation.quantity, v.value);
}

// What is not met is told even to those who asked for quiet.
void print_unmet(const run::RunResult& r) {
  for (const run::Verdict& v : r.verdicts) {
    if (v.met) continue;
    const scenario::Expectation& e = v.expectation;
    std::string wanted;
    if (e.reference)
      wanted += fmt::format(", expected {} ± {:g}, off by {:.3g}", *e.reference, *e.tolerance,
                            v.value - *e.reference);
    if (e.at_most) wanted += fmt::format(", expected at most {}", *e.at_most);
    if (e.at_least) wanted += fmt::format(", expected at least {}", *e.at_least);
    fmt::print("NOT MET  {} ({} = {}{})\n", files::escaped(e.requirement), e.quantity, v.value, wanted);
  }
}

// What a folder of results holds: "12 files"; empty if it is not there.
std::string content_of(const std::filesystem::path& path) {
  std::error_code failed;
  if (!std::filesystem::is_directory(path, failed)) return "";
  const auto files = std::distance(std::filesystem::directory_iterator(path, failed), {});
  return fmt::format(", {} file{}", files, files == 1 ? "" : "s");
}

void print_places(const std::filesystem::path& directory) {
  fmt::print("results in {}\n", directory.string());
  for (const auto& [name, what] :
       {std::pair{"series", "time series (CSV)"},
        {"snapshots", "ParaView files (.vtp, .pvd)"},
        {"images", "pictures (PNG)"},
        {"charts", "charts (PNG)"},
        {"final_packing.csv", "bodies at the end, for the key file of [particles]"},
        {"scenario.toml", "the scenario with its overrides"},
        {"run.json", "summary of the run"}})
    if (const std::filesystem::path path = directory / name; std::filesystem::exists(path))
      fmt::print("  {:<28} {}{}\n", path.string(), what, content_of(path));
}

run::RunOptions options_of(const RunArguments& arguments, ProgressBar& bar) {
  run::RunOptions options;
  options.out = arguments.out;
  options.overwrite = arguments.overwrite;
  options.threads = arguments.threads;
  options.stop = &watch_for_interrupt();
  if (!arguments.quiet) options.on_start = print_carried;
  options.on_progress = [&bar](const run::Progress& p) { bar.show(p); };
  options.on_warning = [&bar](const std::string& line) {
    bar.clear();
    report_warning(line);
  };
  return options;
}

run::RunResult run_with_bar(const scenario::Plan& plan, const RunArguments& arguments) {
  ProgressBar bar(arguments.quiet);
  // Cleared also where an error leaves, so that its line stands alone.
  const std::shared_ptr<void> clearing(nullptr, [&bar](void*) { bar.clear(); });
  return run::run_plan(plan, options_of(arguments, bar));
}

ExitStatus run_scenario(const RunArguments& arguments) {
  PluginHost host = make_host(arguments.plugins);
  const scenario::Plan plan = scenario::read_plan(arguments.scenario, arguments.overrides, host);
  const run::RunResult result = run_with_bar(plan, arguments);
  if (!arguments.quiet) print_result(result);
  print_unmet(result);
  if (result.interrupted) fmt::print("interrupted; results so far are saved\n");
  print_places(result.directory);
  if (result.interrupted) return ExitStatus::interrupted;
  const bool met =
      std::all_of(result.verdicts.begin(), result.verdicts.end(), [](const auto& v) { return v.met; });
  return met ? ExitStatus::success : ExitStatus::failure;
}

}  // namespace

void add_run_verb(CommandLine& line) {
  Verb verb = line.verb("run", "Run a scenario");
  auto arguments = std::make_shared<RunArguments>();
  verb.option("scenario", arguments->scenario, "Scenario file (TOML)").required();
  verb.option("--out", arguments->out, "Directory of the run; default runs/<scenario>, numbered if it exists")
      .shown_as("DIR");
  verb.option("--set", arguments->overrides,
              "Change a value of the scenario, for example --set contact.static_friction=0.2")
      .shown_as("KEY=VALUE");
  verb.option("--threads", arguments->threads,
              "Number of threads; results are bitwise identical for any number (default 1)")
      .between(1, 1024);
  verb.flag("--overwrite", arguments->overwrite, "Replace the files of an existing run in the directory");
  verb.flag("--quiet", arguments->quiet,
            "Print only warnings, unmet expectations and the location of the results");
  add_plugin_options(verb, arguments->plugins);
  verb.footer(
      "Example: scree run scenarios/david2005/quickstart.toml --out runs/first --set "
      "contact.static_friction=0.2");
  verb.action([arguments] { return run_scenario(*arguments); });
}

}  // namespace scree::tool
