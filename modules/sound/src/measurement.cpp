#include "linear.hpp"
#include "measurement_files.hpp"
#include "pulse.hpp"
#include "start.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/run/set_up.hpp>
#include <scree/scene_record.hpp>
#include <scree/sound/measurement.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::sound {

namespace {

namespace fs = std::filesystem;
using run::RunDirectory;

constexpr const char* state_name = "state.h5";
constexpr double seconds_between_states = 60, seconds_between_tables = 1;

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

std::string title_of(const scenario::Plan& plan) {
  return plan.title.empty() ? plan.source.stem().string() : plan.title;
}

Scene last_scene(const scenario::Plan& plan, unsigned threads) {
  Scene scene = scene_in_stage(plan.scene, plan.stages, plan.stages.size());
  scene.threads = threads;
  return scene;
}

class Course {
 public:
  Course(const scenario::Plan& plan, const MeasurementOptions& options, RunDirectory& directory)
      : plan_(plan), options_(options), directory_(directory), asked_(options.roads) {
    result_.title = title_of(plan);
    result_.observed = plan.spectrum->observed;
    result_.directory = directory.path();
  }

  Measurement begin() {
    auto simulation = run::set_up(plan_, options_.threads);
    if (plan_.stages.empty()) set_start(simulation->state());
    if (start_) const DrivenWalls checked(*start_);
    directory_.create();
    try {
      write_record("running", result_, directory_);
      directory_.write_file("scenario.toml", plan_.text_for_any_folder);
      if (!start_) run_stages(*simulation);
      simulation.reset();
      take_roads();
    } catch (const Error& error) {
      if (error.status() == ExitStatus::bad_input) directory_.discard();
      throw;
    }
    return finish();
  }

  Measurement resume(const State& state) {
    const StateTransfer from = StateTransfer::restoring_from(state).below("spectrum");
    transfer(from);
    set_start(state);
    directory_.create();
    write_record("running", result_, directory_);
    if (from.has("sweep/points")) sweep_ = std::make_unique<Sweep>(*start_, state);
    take_roads();
    return finish();
  }

 private:
  void set_start(State state) {
    start_.emplace(Start{plan_, last_scene(plan_, options_.threads), std::move(state), options_.stop,
                         [this](double share, const std::string& what) {
                           if (options_.on_progress) options_.on_progress(share, watch_.seconds(), what);
                         }});
  }

  void run_stages(Simulation& simulation) {
    StageRunner runner(simulation, plan_.stages);
    constexpr std::uint64_t steps_between_reports = 1000;
    const auto proceed = [this] { return !options_.stop || !*options_.stop; };
    while (!runner.finished()) {
      if (!proceed()) throw Error("interrupted before the stages had ended", ExitStatus::interrupted);
      runner.run(steps_between_reports, proceed);
      if (options_.on_progress && !runner.finished())
        options_.on_progress(runner.progress().value_or(0), watch_.seconds(),
                             runner.stages()[runner.current()].name);
    }
    set_start(simulation.state());
  }

  bool asks(Road road) const { return std::find(asked_.begin(), asked_.end(), road) != asked_.end(); }
  bool has(const std::string& road) const {
    return std::any_of(result_.roads.begin(), result_.roads.end(),
                       [&](const auto& r) { return r.road == road; });
  }

  void take_roads() {
    if (!sweep_) {
      take_short(Road::linear, linear_spectrum);
      take_short(Road::pulse, pulse_spectrum);
    }
    if (asks(Road::sweep) && start_->proceeds()) take_sweep();
  }

  // A road that is repeated if it is interrupted. With others to take, one that cannot be taken is left out.
  void take_short(Road road, RoadSpectrum (*take)(const Start&)) {
    const char* const name = road_names[std::size_t(road)];
    if (!asks(road) || has(name) || !start_->proceeds()) return;
    try {
      result_.roads.push_back(take(*start_));
      for (const std::string& note : result_.roads.back().notes) warn(note);
    } catch (const Error& error) {
      if (error.status() == ExitStatus::interrupted) return;
      if (asked_.size() == 1) throw;
      warn(fmt::format("{} (the road {} is left out)", error.what(), name));
      asked_.erase(std::find(asked_.begin(), asked_.end(), road));
    }
  }

  void take_sweep() {
    if (!sweep_) sweep_ = std::make_unique<Sweep>(*start_);
    save();
    sweep_->run([this] {
      const double now = watch_.seconds();
      if (now - last_state_ >= seconds_between_states) {
        last_state_ = now;
        save();
        return;
      }
      kept_ = sweep_->save();
      transfer(StateTransfer::saving_to(*kept_).below("spectrum"));
      if (now - last_table_ >= seconds_between_tables) last_table_ = now, write_sweep_table();
    });
    write_sweep_table();
    write_state(kept_ ? std::move(*kept_) : State());
    for (RoadSpectrum& road : sweep_->spectra()) {
      for (const std::string& note : road.notes) warn(note);
      result_.roads.push_back(std::move(road));
    }
  }

  void save() {
    kept_.reset();
    State state = sweep_->save();
    transfer(StateTransfer::saving_to(state).below("spectrum"));
    write_sweep_table();
    write_state(std::move(state));
  }

  void write_sweep_table() {
    directory_.write_file("sweep.csv", sweep_table(plan_.spectrum->observed, sweep_->points()));
  }

  void write_state(State state) {
    if (!state.arrays().empty()) state_file::write_state(directory_.add(state_name), state);
  }

  void transfer(const StateTransfer& state) {
    std::string scenario = plan_.resolved_text;
    state.value("scenario", "", scenario);
    std::vector<std::string> asked;
    for (const Road road : asked_) asked.push_back(road_names[std::size_t(road)]);
    state.rows("asked", "", asked);
    asked_.clear();
    for (const Road road : {Road::linear, Road::pulse, Road::sweep})
      if (std::find(asked.begin(), asked.end(), road_names[std::size_t(road)]) != asked.end())
        asked_.push_back(road);
    std::uint64_t count = result_.roads.size();
    state.value("count", "1", count);
    result_.roads.resize(count);
    for (std::size_t k = 0; k < count; ++k)
      result_.roads[k].transfer(state.below("road_" + std::to_string(k)));
  }

  void warn(const std::string& line) const {
    if (options_.on_warning) options_.on_warning(line);
  }

  Measurement finish() {
    result_.interrupted = !start_->proceeds();
    // Without a sweep, that with which resume goes on.
    if (result_.interrupted && !sweep_) {
      transfer(StateTransfer::saving_to(start_->state).below("spectrum"));
      write_state(start_->state);
    }
    result_.resonances = resonances_of(result_.roads);
    write_tables(result_, directory_);
    draw_charts(result_, directory_);
    write_record(result_.interrupted ? "interrupted" : "finished", result_, directory_);
    return std::move(result_);
  }

  const scenario::Plan& plan_;
  const MeasurementOptions& options_;
  RunDirectory& directory_;
  std::vector<Road> asked_;
  Measurement result_;
  std::optional<Start> start_;
  std::unique_ptr<Sweep> sweep_;
  std::optional<State> kept_;  // behind the last complete frequency, if it is not in the file
  Stopwatch watch_;
  double last_state_ = 0, last_table_ = 0;  // (s)
};

RunDirectory directory_of(const scenario::Plan& plan, const MeasurementOptions& options) {
  constexpr auto kind = RunDirectory::Kind::spectrum;
  if (options.out.empty()) return RunDirectory::numbered(RunDirectory::default_for(plan.source, kind), kind);
  using Existing = RunDirectory::Existing;
  RunDirectory directory(options.out, options.overwrite ? Existing::replace : Existing::refuse, kind);
  directory.protect(plan.inputs);
  directory.take();
  return directory;
}

std::string status_in(const fs::path& directory) {
  const auto json = nlohmann::json::parse(files::read_text(directory / "spectrum.json"), nullptr, false);
  return json.is_object() && json.contains("status") ? json.value("status", "") : "";
}

}  // namespace

Measurement measure(const scenario::Plan& plan, const MeasurementOptions& options) {
  if (!plan.spectrum)
    throw Error(fmt::format(
        "{}: has no [spectrum]; add one with drive, amplitude, observe, from_hz, to_hz and step_hz",
        plan.source.string()));
  RunDirectory directory = directory_of(plan, options);
  return Course(plan, options, directory).begin();
}

bool is_measurement(const fs::path& directory) {
  std::error_code failed;
  return fs::exists(directory / "spectrum.json", failed);
}

Measurement resume_measurement(const MeasurementOptions& options, PluginHost& host) {
  if (!is_measurement(options.out))
    throw Error(fmt::format("{}: contains no spectrum; give the directory of one", options.out.string()));
  RunDirectory directory(options.out, RunDirectory::Existing::keep, RunDirectory::Kind::spectrum);
  directory.take();
  if (status_in(options.out) == "finished")
    throw Error(
        fmt::format("{}: the spectrum is finished; give --overwrite with the scenario to measure it again",
                    options.out.string()));
  const State state = state_file::read_state(options.out / state_name);
  std::string text;
  StateTransfer::restoring_from(state).below("spectrum").value("scenario", "", text);
  const scenario::Plan plan = scenario::read_plan_again(
      text, (options.out / state_name).string() + " (scenario)", {}, bodies_at_start(state), host);
  return Course(plan, options, directory).resume(state);
}

}  // namespace scree::sound
