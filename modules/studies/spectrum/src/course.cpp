#include "course.hpp"

#include "linear.hpp"
#include "measurement_charts.hpp"
#include "measurement_files.hpp"
#include "pulse.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/files/try_each.hpp>
#include <scree/run/run_stages.hpp>
#include <scree/run/set_up.hpp>

namespace scree::spectrum {

namespace {

constexpr double seconds_between_states = 60, seconds_between_tables = 1;

Scene last_scene(const scenario::Plan& plan, unsigned threads) {
  Scene scene = scene_in_stage(plan.scene, plan.stages, plan.stages.size());
  scene.threads = threads;
  return scene;
}

}  // namespace

Course::Course(const scenario::Plan& plan, SpectrumPlan spectrum, const MeasurementOptions& options,
               run::RunDirectory& directory)
    : plan_(plan),
      spectrum_(std::move(spectrum)),
      options_(options),
      directory_(directory),
      asked_(options.methods) {
  result_.title = plan.heading();
  result_.observed = spectrum_.observed;
  result_.directory = directory.path();
  result_.scenario = plan.resolved_text;
  result_.inputs = run::hashes_of(plan.files);
}

Measurement Course::begin() {
  auto simulation = run::set_up(plan_, options_.threads);
  if (!plan_.stages.empty()) check_before_stages(plan_, spectrum_, asked_);
  for (const std::string& line : simulation->let_go()) warn(line);
  // What is there stays until something can take its place.
  StageRunner runner(*simulation, plan_.stages);
  if ((plan_.stages.empty() || options_.overwrite) && !run_stages(*simulation, runner))
    throw Error(
        fmt::format(
            "{}: interrupted before the stages had ended; nothing was written; run the same command again",
            plan_.source.string()),
        ExitStatus::interrupted);
  if (start_) check_start(*simulation);
  directory_.begin([this] {
    write_record("running", result_, directory_);
    room_.reserve(directory_, results.record);
    directory_.write_file("scenario.toml", plan_.text_for_any_folder);
  });
  try {
    if (!start_ && !run_stages(*simulation, runner)) return stop_in_stages(*simulation, runner);
    simulation.reset();
    measure_by_methods();
    return finish();
  } catch (const Error& error) {
    if (error.status() == ExitStatus::bad_input && result_.spectra.empty() && !sweep_) {
      directory_.discard();
      throw;
    }
    if (error.status() != ExitStatus::interrupted) save_failed(files::record_line(error, false));
    files::rethrow_as_failure(error);
  } catch (const std::exception& error) {  // such as of memory
    save_failed(error.what());
    throw;
  }
}

Measurement Course::resume(const State& state) {
  const StateTransfer from = StateTransfer::restoring_from(state).below("spectrum");
  transfer(from);
  const bool in_stages = from.has("stages/stage");
  if (!in_stages) set_start(state);
  // A state that does not fit is refused before anything is written.
  std::unique_ptr<Simulation> in_stage;
  std::optional<StageRunner> runner;
  if (in_stages) {
    in_stage = run::resumed(plan_, state, from.below("stages"), options_.threads);
    runner.emplace(*in_stage, plan_.stages, from.below("stages"));
  } else if (from.has("sweep/points")) {
    sweep_ = std::make_unique<Sweep>(*start_, state);
  } else {
    Simulation(start_->scene, state);
  }
  directory_.create();
  room_.reserve(directory_, results.record);
  try {
    write_record("running", result_, directory_);
    if (!plan_.text_for_any_folder.empty()) directory_.write_file("scenario.toml", plan_.text_for_any_folder);
    if (in_stages) return go_on_in_stages(std::move(in_stage), *runner);
    measure_by_methods();
    return finish();
  } catch (const Error& error) {
    if (error.status() != ExitStatus::interrupted) save_failed(files::record_line(error, true));
    files::rethrow_as_failure(error);
  } catch (const std::exception& error) {
    save_failed(error.what());
    throw;
  }
}

void Course::save_failed(const std::string& failure) {
  result_.error = failure;
  room_.release();
  files::try_each([&] { write_record("failed", result_, directory_); },
                  [&] {
                    if (sweep_) write_sweep_table();
                  },
                  [&] {
                    if (kept_) write_state(*kept_);
                  });
}

void Course::set_start(State state) {
  start_.emplace(Start{plan_, spectrum_, last_scene(plan_, options_.threads), std::move(state), options_.stop,
                       [this](double share, const std::string& what) {
                         if (options_.on_progress) options_.on_progress(share, seconds(), what);
                       }});
}

// Refuses what cannot be measured before anything is written; of several methods, one that fails is skipped later.
void Course::check_start(const Simulation& simulation) const {
  const DrivenWalls checked(*start_);
  check_observed(plan_, spectrum_.observed, simulation);
  if (asked_.size() > 1) return;
  if (asks(Method::linear))
    check_linear(*start_);
  else
    check_amplitude(*start_, asks(Method::pulse) ? spectrum_.pulse_amplitude() : spectrum_.amplitude);
  if (asks(Method::linear) && options_.overwrite) check_response(*start_);
}

bool Course::run_stages(Simulation& simulation, StageRunner& runner) {
  const bool ended = run::run_stages(
      runner, [this] { return proceeds(); },
      [this](double share, const std::string& stage) {
        if (options_.on_progress) options_.on_progress(share, seconds(), stage);
      });
  if (ended) set_start(simulation.state());
  return ended;
}

Measurement Course::stop_in_stages(const Simulation& simulation, const StageRunner& runner) {
  State state = simulation.state();
  const StateTransfer to = StateTransfer::saving_to(state).below("spectrum");
  runner.save(to.below("stages"));
  transfer(to);
  write_state(state);
  result_.interrupted = true;
  room_.release();
  write_record("interrupted", result_, directory_);
  return std::move(result_);
}

Measurement Course::go_on_in_stages(std::unique_ptr<Simulation> simulation, StageRunner& runner) {
  if (!run_stages(*simulation, runner)) return stop_in_stages(*simulation, runner);
  simulation.reset();
  measure_by_methods();
  return finish();
}

bool Course::asks(Method method) const {
  return std::find(asked_.begin(), asked_.end(), method) != asked_.end();
}

bool Course::has(const std::string& method) const {
  return std::any_of(result_.spectra.begin(), result_.spectra.end(),
                     [&](const auto& r) { return r.method == method; });
}

void Course::measure_by_methods() {
  if (!sweep_) {
    take_short(Method::linear, [this](const Start& start) {
      if (!add_linear(start, unfinished_, [this] { save_unfinished(); }))
        throw Error("interrupted in the linear response", ExitStatus::interrupted);
      return std::exchange(unfinished_, {});
    });
    take_short(Method::pulse, pulse_spectrum);
  }
  if (asks(Method::sweep) && proceeds()) take_sweep();
}

void Course::take_short(Method method, const std::function<MethodSpectrum(const Start&)>& take) {
  const char* const name = method_names[std::size_t(method)];
  if (!asks(method) || has(name) || !proceeds()) return;
  try {
    result_.spectra.push_back(take(*start_));
    for (const std::string& note : result_.spectra.back().notes) warn(note);
  } catch (const Error& error) {
    if (error.status() == ExitStatus::interrupted) return;
    if (asked_.size() == 1) throw;
    if (method == Method::linear) unfinished_ = {};
    warn(fmt::format("{} (method '{}' skipped)", error.what(), name));
    asked_.erase(std::find(asked_.begin(), asked_.end(), method));
    left_out_.push_back(name);
  }
}

void Course::save_unfinished() {
  if (seconds() - last_state_ < seconds_between_states) return;
  last_state_ = seconds();
  save_without_sweep();
}

void Course::take_sweep() {
  if (!sweep_) sweep_ = std::make_unique<Sweep>(*start_);
  save();
  sweep_->run([this] {
    const double now = seconds();
    if (now - last_state_ >= seconds_between_states) {
      last_state_ = now;
      return save();
    }
    kept_ = sweep_->save();
    transfer(StateTransfer::saving_to(*kept_).below("spectrum"));
    if (now - last_table_ >= seconds_between_tables) last_table_ = now, write_sweep_table();
  });
  write_sweep_table();
  if (kept_) write_state(*kept_);
  for (MethodSpectrum& spectrum : sweep_->spectra()) {
    for (const std::string& note : spectrum.notes) warn(note);
    result_.spectra.push_back(std::move(spectrum));
  }
}

void Course::warn(const std::string& line) {
  result_.warnings.push_back(line);
  if (options_.on_warning) options_.on_warning(line);
}

Measurement Course::finish() {
  result_.interrupted = !proceeds();
  // Without a sweep, that with which resume goes on.
  if (result_.interrupted && !sweep_) {
    save_without_sweep();
    if (!unfinished_.frequencies.empty()) result_.spectra.push_back(without_linearity(unfinished_));
  }
  result_.resonances = resonances_of(result_.spectra, result_.observed);
  if (!result_.interrupted)
    for (const std::string& line : missing_peaks(result_.spectra, result_.resonances, result_.observed))
      warn(line);
  judge();
  write_tables(result_, directory_);
  draw_charts(result_, directory_, [this](const std::string& line) { warn(line); });
  room_.release();
  write_record(result_.interrupted ? "interrupted" : "finished", result_, directory_);
  return std::move(result_);
}

void Course::judge() {
  if (result_.interrupted) return;
  for (const scenario::Expectation& e : spectrum_.expectations) {
    const auto quantity = *peak_quantity(e.quantity, result_.observed);
    const std::string method = method_names[quantity.method];
    const bool left_out = std::find(left_out_.begin(), left_out_.end(), method) != left_out_.end();
    if (!has(method) && !left_out) continue;  // not asked for
    result_.verdicts.push_back(run::judged(e, value_of(quantity, result_.spectra, result_.resonances)));
  }
}

double Course::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

}  // namespace scree::spectrum
