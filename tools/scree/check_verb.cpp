#include "program_verbs.hpp"
#include "run_report.hpp"
#include "scene_facts.hpp"
#include "support/study_tables.hpp"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>
#include <scree/run/charts.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/step_check.hpp>
#include <scree/run/warnings.hpp>
#include <scree/surface_checks.hpp>

namespace scree::tool {

namespace {

struct CheckArguments {
  std::string scenario;
  std::vector<std::string> overrides;
  PluginOptions plugins;
};

void print_stages(const scenario::Plan& plan) {
  double least = 0;
  for (const Stage& stage : plan.stages) {
    const double length = stage.duration ? *stage.duration : stage.until.at_least;
    least += length;
    if (stage.duration)
      fmt::print("  stage {}: {:g} s, {}\n", files::escaped(stage.name), length,
                 counted(std::size_t(std::llround(length / plan.scene.step)), "step"));
    else
      fmt::print("  stage {}: until {}, at most {:g} s\n", files::escaped(stage.name),
                 files::escaped(stage.until.text()), *stage.until.at_most);
  }
  fmt::print("  at least {:g} s of simulated time\n", least);
}

void print_summary(const std::string& file, const scenario::Plan& plan, const Simulation& simulation,
                   const std::string& step) {
  fmt::print("{}: valid{}{}\n", files::escaped(file), plan.title.empty() ? "" : ", ",
             files::escaped(plan.title));
  fmt::print("  {}, {}, {}, {}, {}\n", run::describe_bodies(simulation),
             counted(simulation.planes().size() + simulation.surfaces().size(), "wall"),
             counted(plan.scene.laws.size(), "contact law"),
             counted(plan.scene.body_forces.size(), "body force"), counted(plan.probes.size(), "probe"));
  fmt::print("  {}\n  {}\n", extent_of_bodies(simulation), step);
  print_sources(plan);
  for (const std::string& line : mesh_lines(simulation.surfaces())) fmt::print("  {}\n", line);
  if (const run::LargestOverlap largest = run::largest_overlap(simulation); largest.ratio > 0)
    fmt::print("  largest overlap at t = 0: {:.3g} of the smaller radius, {}\n", largest.ratio,
               largest.bodies);
  if (!plan.stages.empty()) print_stages(plan);
  for (const scenario::StudyTable& study : study_tables())
    if (const std::string line = study.check(plan); !line.empty()) fmt::print("  {}\n", line);
}

ExitStatus check(const CheckArguments& arguments) {
  PluginHost host = make_host(arguments.plugins);
  const scenario::Plan plan =
      scenario::read_plan(arguments.scenario, arguments.overrides, host, study_tables());
  const auto simulation = run::set_up(plan);
  // What a plug-in states may be refused: nothing is printed before.
  const std::string step = run::describe_step(*simulation);
  std::vector<std::string> warnings = run::start_warnings(plan, *simulation);
  for (const std::string& line : unusual_numbers(plan)) warnings.push_back(line);
  print_summary(arguments.scenario, plan, *simulation, step);
  for (const std::string& line : run::left_out_at_start(plan, *simulation)) fmt::print("  {}\n", line);
  if (const std::string line = expected_wall_time(plan, *simulation); !line.empty())
    fmt::print("  {}\n", line);
  for (const std::string& warning : warnings) report_warning(warning);
  return ExitStatus::success;
}

}  // namespace

void add_check_verb(CommandLine& line) {
  Verb verb = line.verb("check", "Validate a scenario without running it");
  auto arguments = std::make_shared<CheckArguments>();
  verb.option("scenario", arguments->scenario, "Scenario file (TOML)").required();
  verb.option("--set", arguments->overrides, "Change a value of the scenario").shown_as("KEY=VALUE");
  add_plugin_options(verb, arguments->plugins);
  verb.footer(
      "Example: scree check scenarios/david2005/quickstart.toml --set particles.lattice.count=[10,10,10]");
  verb.action([arguments] { return check(*arguments); });
}

}  // namespace scree::tool
