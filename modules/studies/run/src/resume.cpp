#include "checkpoints.hpp"
#include "results.hpp"
#include "run.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/document/document.hpp>
#include <scree/files/place_error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/scene_record.hpp>
#include <scree/state_error.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

namespace {

namespace fs = std::filesystem;

// The length of a stage may change, but nothing that has shaped the run so far.
bool is_length(const std::string& override_text) {
  const std::string key = override_text.substr(0, override_text.find('='));
  const std::string last = key.substr(key.rfind('.') + 1);
  // Functions of time have durations and cycles too: stage.press.set.box.stress_z.duration.
  if (key.find(".set.") != key.npos) return false;
  return (key.starts_with("stage") || key.starts_with("time")) &&
         (last == "duration" || last == "cycles" || last == "at_most" || last == "otherwise");
}

// How far a run has come in its stages.
struct Position {
  std::size_t stage;  // the present one, or the last if all have ended
  double began;       // (s)
  bool ended;         // whether all have
};

// Throws Error unless all overrides set lengths of stages.
void check_overrides(const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides)
    if (!is_length(text))
      throw Error(
          fmt::format("--set {}: a run that goes on can change only how long its stages last (duration, "
                      "cycles, at_most, otherwise); begin a new run from its state (particles.state)",
                      text));
}

// Of the state of a run.
Position position_of(const State& state, const scenario::Plan& plan) {
  const StateTransfer stages = StateTransfer::restoring_from(state).below("run/stages");
  if (plan.stages.empty()) stages.refuse("stage", "is one of a scenario without stages");
  Position position = {stage_of(stages), 0, false};
  stages.value("began", "s", position.began);
  position.ended = position.stage >= plan.stages.size();
  if (position.ended) position.stage = plan.stages.size() - 1;
  return position;
}

// Throws Error if a stage that is over would have another length.
void check_past(const scenario::Plan& before, const scenario::Plan& now, const Position& position) {
  for (std::size_t k = 0; k < std::min(position.stage, now.stages.size()); ++k)
    if (before.stages[k].duration != now.stages[k].duration ||
        before.stages[k].until.at_most != now.stages[k].until.at_most)
      throw Error(
          fmt::format("--set: stage '{}' is over, so that its length cannot change; set that of stage '{}'{}",
                      now.stages[k].name, now.stages[position.stage].name,
                      position.stage + 1 < now.stages.size() ? " or a later one" : ""));
}

// The override that makes a plan end at a time (s). Throws Error if its last stage cannot end there.
std::string duration_until(const scenario::Plan& plan, const Position& position, double until) {
  const std::vector<Stage>& stages = plan.stages;
  if (position.ended && !stages.back().duration)
    throw Error(
        fmt::format("--until: stage '{}' has no duration, and has ended by its condition or at_most; "
                    "begin a new run from the state (particles.state)",
                    stages.back().name));
  double begin = position.began;
  for (std::size_t k = position.stage; k + 1 < stages.size(); ++k) begin += stages[k].duration.value_or(NAN);
  if (!stages.back().duration || std::isnan(begin))
    throw Error(
        "--until: the time at which the last stage ends is not known, as a stage ends by a condition; "
        "give --set stage.<name>.duration=<s> or at_most=<s>");
  if (!(until > begin))
    throw Error(
        fmt::format("--until {:g}: the last stage begins at {:g} s; give a later time", until, begin));
  return scenario::length_override(plan.resolved_text, until - begin);
}

// The scenario that the directory holds, or that which is to be restored there, with overrides.
std::string text_in(const fs::path& directory, const std::string& restored,
                    const std::vector<std::string>& overrides) {
  using document::Document;
  return (restored.empty() ? Document::load(directory / scenario_file, overrides)
                           : Document::parse(restored, scenario_file, overrides))
      .resolved_text();
}

std::string scenario_of(const State& state) {
  std::string text;
  StateTransfer::restoring_from(state).below("run").value("scenario", "", text);
  return text;
}

// A scenario with all lengths of its stages set to 1, by which two that differ in these alone are the same.
std::string without_lengths(const std::string& text) {
  const document::Document document = document::Document::parse(text, scenario_file);
  std::vector<std::string> equal;
  const auto add = [&](const document::Table& table, const std::string& path) {
    for (const char* key : {"duration", "cycles", "at_most", "otherwise"})
      if (table.has(key)) equal.push_back(fmt::format("{}.{}=1", path, key));
  };
  const std::vector<document::Table> stages = document.root().tables("stage");
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const std::string path = stages.size() == 1 ? "stage" : fmt::format("stage[{}]", k);
    add(stages[k], path);
    if (stages[k].is_table("until")) add(stages[k].table("until"), path + ".until");
  }
  if (document.root().is_table("time")) add(document.root().table("time"), "time");
  return document::Document::parse(text, scenario_file, equal).resolved_text();
}

// The scenario of a state with the lengths in run.json, which has them as soon as a run is prolonged.
std::string with_recorded_lengths(const std::string& of_state, const std::string& recorded) {
  try {
    if (!recorded.empty() && without_lengths(of_state) == without_lengths(recorded)) return recorded;
  } catch (const Error&) {
    // A record that was edited.
  }
  return of_state;
}

// The plan of a run with the changes; `read` reads it with overrides.
template <class Read>
scenario::Plan changed_plan(const ResumeChanges& changes, const State* state, const Read& read) {
  std::vector<std::string> overrides = changes.overrides;
  scenario::Plan plan = read(overrides);
  const Position position = state ? position_of(*state, plan) : Position{0, 0, false};
  if (!overrides.empty()) check_past(read({}), plan, position);
  if (!changes.until) return plan;
  overrides.push_back(duration_until(plan, position, *changes.until));
  return read(overrides);
}

scenario::Plan plan_of(const Checkpoints::Latest& latest, const RecordedBodies& bodies,
                       const RunOptions& options, const ResumeChanges& changes, PluginHost& host) {
  const std::string text =
                        with_recorded_lengths(scenario_of(latest.state), recorded_in(options.out).scenario),
                    name = latest.path.string() + " (scenario)",
                    restored = restored_scenario(options.out, text, options.on_warning);
  return changed_plan(changes, &latest.state, [&](const std::vector<std::string>& overrides) {
    scenario::Plan plan = scenario::read_plan_again(text, name, overrides, bodies, host);
    if (!overrides.empty() || !restored.empty())
      plan.text_for_any_folder = text_in(options.out, restored, overrides);
    return plan;
  });
}

// Of a run that was killed before its first state: from its start. Its warnings are those of its first
// beginning, with their places in the file with which it was begun.
scenario::Plan plan_at_start(const RunOptions& options, const ResumeChanges& changes, PluginHost& host,
                             const scenario::StudyTables& studies) {
  const fs::path& directory = options.out;
  const Recorded before = recorded_in(directory);
  if (!before.scenario.empty())
    if (const auto text = restored_scenario(directory, before.scenario, options.on_warning); !text.empty())
      files::write_atomically(directory / scenario_file, text);
  scenario::Plan plan = changed_plan(changes, nullptr, [&](const std::vector<std::string>& overrides) {
    return scenario::read_plan(directory / scenario_file, overrides, host, studies);
  });
  if (changes.overrides.empty() && before.warnings.size() >= plan.warnings.size())
    std::copy_n(before.warnings.begin(), plan.warnings.size(), plan.warnings.begin());
  return plan;
}

RunDirectory directory_of(const fs::path& path, const std::function<void(const std::string&)>& on_warning) {
  std::error_code failed;
  if (!fs::exists(path / "run.json", failed))
    throw Error(fmt::format("{}: contains no run; give the directory of a run, spectrum or quasi-static load",
                            path.string()));
  RunDirectory directory(path, RunDirectory::Existing::keep);
  directory.take();
  directory.report_lock(on_warning);
  return directory;
}

// Throws Error if nothing is left to do.
void check_unfinished(const State& state, const scenario::Plan& plan, const fs::path& directory) {
  const Position position = position_of(state, plan);
  const std::optional<double> last = plan.stages.back().duration;
  const bool prolonged = last && position.began + *last > time_of(state) + 0.5 * plan.scene.step;
  // It may have been killed between its last state and its last record.
  if (position.ended && !prolonged && recorded_in(directory).status == "finished")
    throw Error(fmt::format("{}: the run has finished at t = {:g} s; {}", directory.string(), time_of(state),
                            last ? "give a later --until to prolong it"
                                 : "its last stage has no duration: begin a new run from its state "
                                   "(particles.state)"));
}

// A plan, and the simulation of a state from which it goes on.
struct Start {
  scenario::Plan plan;
  std::unique_ptr<Simulation> simulation;
};

// Returns why the state is refused; throws Error if the changes are.
std::optional<std::string> begin_from(const Checkpoints::Latest& latest, const RunOptions& options,
                                      const ResumeChanges& changes, PluginHost& host, Start& start) {
  try {
    start.plan = plan_of(latest, recorded_bodies(latest.state), options, changes, host);
  } catch (const StateError& error) {
    return error.what();
  }
  try {
    const StateTransfer stages = StateTransfer::restoring_from(latest.state).below("run/stages");
    start.simulation = resumed(start.plan, latest.state, stages, options.threads, options.ranks);
    return std::nullopt;
  } catch (const Error& error) {
    return error.what();
  }
}

void refuse_loss(const fs::path& directory, bool has_state, const std::string& from) {
  if (!has_state)
    throw Error(
        fmt::format("{}: there is no state to go on from, and the run would begin anew; give --overwrite "
                    "to replace its results",
                    directory.string()));
  if (!from.empty())
    throw Error(
        fmt::format("--from {}: results after this stage would be replaced; give --overwrite too, or begin "
                    "another run from its state ([particles] state)",
                    from));
}

RunResult go_on(const RunOptions& options, const ResumeChanges& changes, PluginHost& host,
                const scenario::StudyTables& studies) {
  check_overrides(changes.overrides);
  RunDirectory directory = directory_of(options.out, options.on_warning);
  const auto warn = [&](const std::string& line) {
    if (options.on_warning) options.on_warning(line);
  };
  Start start;
  const auto refusal = [&](const Checkpoints::Latest& state) {
    return begin_from(state, options, changes, host, start);
  };
  const Checkpoints states(directory);
  const auto latest = changes.from.empty() ? states.latest(refusal, warn)
                                           : std::optional(states.at_end_of(changes.from, refusal));
  if (!options.overwrite) refuse_loss(options.out, latest.has_value(), changes.from);
  if (!latest) start.plan = plan_at_start(options, changes, host, studies);
  scenario::Plan& plan = start.plan;
  if (changes.checkpoint_every) plan.checkpoint.every = *changes.checkpoint_every;
  if (latest) {
    check_unfinished(latest->state, plan, options.out);
  } else {
    warn(fmt::format("{}: there is no state yet; the run begins anew", options.out.string()));
    directory.replace();
    start.simulation = set_up(plan, options.threads, options.ranks);
  }
  Session session(run_results, plan, session_options_of(options), std::move(directory));
  Run run(plan, options, session, std::move(start.simulation));
  latest ? session.resume(run, latest->state, latest->path) : session.begin(run);
  return run.result();
}

}  // namespace

RunResult resume_run(const RunOptions& options, const ResumeChanges& changes, PluginHost& host,
                     const scenario::StudyTables& studies) {
  return files::in_place([&] { return go_on(options, changes, host, studies); });
}

}  // namespace scree::run
