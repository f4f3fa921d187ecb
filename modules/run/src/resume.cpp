#include "checkpoints.hpp"
#include "run_from.hpp"

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/error.hpp>
#include <scree/scene_record.hpp>

namespace scree::run {

namespace {

// The length of a stage may change, but nothing that has shaped the run so far.
bool is_length(const std::string& override_text) {
  const std::string key = override_text.substr(0, override_text.find('='));
  const std::string last = key.substr(key.rfind('.') + 1);
  return last == "duration" || last == "cycles" || last == "at_most";
}

void check_overrides(const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides)
    if (!is_length(text))
      throw Error(
          fmt::format("--set {}: a run that goes on can change only how long its stages last (duration, "
                      "cycles, at_most); begin a new run from its state (particles.state)",
                      text));
}

// The override that makes a plan end at a time (s).
std::string duration_until(const scenario::Plan& plan, double until) {
  double begin = 0;
  for (std::size_t k = 0; k + 1 < plan.stages.size(); ++k) begin += plan.stages[k].duration.value_or(NAN);
  const bool timed = plan.stages.back().duration.has_value() && !std::isnan(begin);
  if (!timed)
    throw Error(
        "--until: the time at which the last stage ends is not known, as a stage ends by a condition; "
        "give --set stage.<name>.duration=<s> or at_most=<s>");
  if (!(until > begin))
    throw Error(
        fmt::format("--until {:g}: the last stage begins at {:g} s; give a later time", until, begin));
  const std::string duration = document::number_text(until - begin);
  return plan.stages.size() > 1 ? fmt::format("stage[{}].duration={}", plan.stages.size() - 1, duration)
                                : fmt::format("time.duration={}", duration);
}

std::string scenario_of(const State& state) {
  std::string text;
  StateTransfer::restoring_from(state).below("run").value("scenario", "", text);
  return text;
}

scenario::Plan plan_of(const Checkpoints::Latest& latest, const ResumeChanges& changes, PluginHost& host) {
  const std::string text = scenario_of(latest.state), name = latest.path.string() + " (scenario)";
  std::vector<std::string> overrides = changes.overrides;
  const auto read = [&] {
    return scenario::read_plan_again(text, name, overrides, bodies_at_start(latest.state), host);
  };
  scenario::Plan plan = read();
  if (!changes.until) return plan;
  overrides.push_back(duration_until(plan, *changes.until));
  return read();
}

// Of a run that was killed before its first state: from its start.
scenario::Plan plan_of(const std::filesystem::path& scenario, const ResumeChanges& changes,
                       PluginHost& host) {
  std::vector<std::string> overrides = changes.overrides;
  const scenario::Plan plan = scenario::read_plan(scenario, overrides, host);
  if (!changes.until) return plan;
  overrides.push_back(duration_until(plan, *changes.until));
  return scenario::read_plan(scenario, overrides, host);
}

RunDirectory directory_of(const std::filesystem::path& path) {
  std::error_code failed;
  if (!std::filesystem::exists(path / "run.json", failed))
    throw Error(fmt::format("{}: contains no run; give the directory of one", path.string()));
  RunDirectory directory(path, RunDirectory::Existing::keep);
  directory.take();
  return directory;
}

}  // namespace

RunResult resume_run(const RunOptions& options, const ResumeChanges& changes, PluginHost& host) {
  check_overrides(changes.overrides);
  RunDirectory directory = directory_of(options.out);
  const auto latest = Checkpoints(directory).latest(options.on_warning);
  scenario::Plan plan =
      latest ? plan_of(*latest, changes, host) : plan_of(options.out / "scenario.toml", changes, host);
  if (changes.checkpoint_every) plan.checkpoint.every = *changes.checkpoint_every;
  if (!latest) directory.replace();
  return run_from(latest ? &latest->state : nullptr, plan, options, directory);
}

}  // namespace scree::run
