#include "driven_walls.hpp"
#include "linear.hpp"
#include "measurement_charts.hpp"
#include "measurement_files.hpp"
#include "observer.hpp"
#include "pulse.hpp"
#include "start.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/run/run_stages.hpp>
#include <scree/run/session.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/spectrum/measurement.hpp>
#include <scree/stage.hpp>

namespace scree::spectrum {

namespace {

constexpr double seconds_between_tables = 1;

// The study of a spectrum, from its start or from a state to its last file.
class SpectrumStudy : public run::Study {
 public:
  SpectrumStudy(const scenario::Plan& plan, SpectrumPlan spectrum, const MeasurementOptions& options,
                run::Session& session)
      : plan_(plan),
        spectrum_(std::move(spectrum)),
        options_(options),
        session_(session),
        directory_(session.directory()),
        asked_(options.methods) {
    result_.title = plan.heading();
    result_.observed = spectrum_.observed;
  }

  // The stages, if they have not run in prepare(); then each method that is asked for, the short ones first;
  // then peaks, tables and charts of what is complete.
  bool work() override {
    if (!start_ && !run_stages_in_directory()) return false;
    stages_.reset();
    simulation_.reset();
    if (!sweep_) {
      take_linear();
      take_pulse();
    }
    if (asks(Method::sweep) && session_.proceeds()) take_sweep();
    const bool complete = session_.proceeds();
    if (!complete && !sweep_) keep_without_sweep();
    find_peaks(complete);
    write_tables(result_, directory_);
    draw_charts(result_, directory_, [this](const std::string& line) { session_.warn(line); });
    return complete;
  }

  // What is there stays until something can take its place: with overwrite the stages run before anything is
  // written.
  void prepare() override {
    simulation_ = run::set_up(plan_, options_.threads);
    if (!plan_.stages.empty()) check_before_stages(plan_, spectrum_, asked_);
    for (const std::string& line : simulation_->let_go()) session_.warn(line);
    stages_.emplace(run::stage_runner(*simulation_, plan_));
    if (!plan_.stages.empty() && !options_.overwrite) return;
    if (!session_.run_stages(*stages_, plan_.stages.size()))
      throw session_.stopped_before("the stages had ended");
    set_start(simulation_->state());
    check_start();
  }

  void restore(const State& state) override {
    const StateTransfer from = StateTransfer::restoring_from(state).below(run::spectrum_results.group);
    session_.transfer(from);
    if (from.has("stages/stage")) {
      simulation_ = run::resumed(plan_, state, from.below("stages"), options_.threads);
      stages_.emplace(run::stage_runner(*simulation_, plan_, from.below("stages")));
      return;
    }
    set_start(state);
    if (from.has("sweep/points"))
      sweep_ = std::make_unique<Sweep>(*start_, state);
    else
      Simulation(start_->scene, state);  // refuses a state that does not fit
  }

  bool has_results() const override { return sweep_ || !result_.spectra.empty(); }
  void save_failed() override {
    if (sweep_) write_sweep_table();
  }
  void transfer(const StateTransfer& state) override;
  nlohmann::ordered_json record() override { return record_of(result_); }

  Measurement result() {
    result_.directory = directory_.path();
    result_.interrupted = session_.interrupted();
    result_.inputs = session_.inputs();
    result_.warnings = session_.warnings();
    return std::move(result_);
  }

 private:
  void set_start(State state);
  void check_start() const;
  bool run_stages_in_directory();
  void keep_in_stages();

  bool asks(Method method) const { return std::find(asked_.begin(), asked_.end(), method) != asked_.end(); }
  bool has(const std::string& method) const {
    return std::any_of(result_.spectra.begin(), result_.spectra.end(),
                       [&](const auto& r) { return r.method == method; });
  }
  void take_linear();
  void take_pulse();
  // Measures by a method that is not a sweep. A method that fails is skipped if there are others.
  template <class Take>
  void take(Method method, const Take& take);
  void take_sweep();
  // The state with which a study without a sweep goes on.
  void keep_without_sweep();
  void keep_sweep();
  void write_sweep_table();
  void find_peaks(bool complete);
  void judge();

  const scenario::Plan& plan_;
  const SpectrumPlan spectrum_;
  const MeasurementOptions& options_;
  run::Session& session_;
  const run::RunDirectory& directory_;
  std::vector<Method> asked_;
  std::vector<std::string> left_out_;  // asked for, but could not be taken
  Measurement result_;
  MethodSpectrum unfinished_;               // linear method of a part of the frequencies
  std::unique_ptr<Simulation> simulation_;  // in the stages
  std::optional<StageRunner> stages_;
  std::optional<Start> start_;  // after the stages
  std::unique_ptr<Sweep> sweep_;
  double last_table_ = 0;  // (s) of wall time
};

void SpectrumStudy::set_start(State state) {
  Scene scene = scene_in_stage(plan_.scene, plan_.stages, plan_.stages.size());
  scene.threads = options_.threads;
  start_.emplace(Start{plan_, spectrum_, std::move(scene), std::move(state), options_.stop,
                       [this](double share, const std::string& what) { session_.report(share, what); }});
}

// Refuses what cannot be measured before anything is written; of several methods, one that fails is skipped
// later.
void SpectrumStudy::check_start() const {
  const DrivenWalls checked(*start_);
  check_observed(plan_, spectrum_.observed, *simulation_);
  if (asked_.size() > 1) return;
  if (asks(Method::linear))
    check_linear(*start_);
  else
    check_amplitude(*start_, asks(Method::pulse) ? spectrum_.pulse_amplitude() : spectrum_.amplitude);
  if (asks(Method::linear) && options_.overwrite) check_response(*start_);
}

bool SpectrumStudy::run_stages_in_directory() {
  const bool ended = run::run_stages(
      *stages_, plan_.stages.size(), [this] { return session_.proceeds(); },
      [this](double share, const std::string& stage) {
        session_.report(share, stage);
        if (session_.is_state_due(simulation_->time())) keep_in_stages();
      });
  if (!ended) {
    keep_in_stages();
    return false;
  }
  set_start(simulation_->state());
  return true;
}

void SpectrumStudy::keep_in_stages() {
  State state = simulation_->state();
  stages_->save(StateTransfer::saving_to(state).below(run::spectrum_results.group).below("stages"));
  session_.keep(std::move(state), simulation_->time());
}

template <class Take>
void SpectrumStudy::take(Method method, const Take& take) {
  const char* const name = method_names[std::size_t(method)];
  if (!asks(method) || has(name) || !session_.proceeds()) return;
  try {
    result_.spectra.push_back(take());
    for (const std::string& note : result_.spectra.back().notes) session_.warn(note);
  } catch (const Error& error) {
    if (error.status() == ExitStatus::interrupted) return;
    if (asked_.size() == 1) throw;
    if (method == Method::linear) unfinished_ = {};
    session_.warn(fmt::format("{} (method '{}' skipped)", error.what(), name));
    asked_.erase(std::find(asked_.begin(), asked_.end(), method));
    left_out_.push_back(name);
  }
}

void SpectrumStudy::take_linear() {
  const auto on_part = [this] {
    if (session_.is_state_due(time_of(start_->state))) keep_without_sweep();
  };
  take(Method::linear, [&] {
    if (!add_linear(*start_, unfinished_, on_part))
      throw Error("interrupted in the linear response", ExitStatus::interrupted);
    return std::exchange(unfinished_, {});
  });
}

void SpectrumStudy::take_pulse() {
  take(Method::pulse, [this] { return pulse_spectrum(*start_); });
}

void SpectrumStudy::take_sweep() {
  if (!sweep_) sweep_ = std::make_unique<Sweep>(*start_);
  keep_sweep();
  write_sweep_table();
  sweep_->run([this] {
    keep_sweep();
    if (session_.wall() - last_table_ < seconds_between_tables) return;
    last_table_ = session_.wall();
    write_sweep_table();
  });
  write_sweep_table();
  for (MethodSpectrum& method : sweep_->spectra()) {
    for (const std::string& note : method.notes) session_.warn(note);
    result_.spectra.push_back(std::move(method));
  }
}

void SpectrumStudy::keep_sweep() {
  State state = sweep_->save();
  const double time = time_of(state);
  session_.keep(std::move(state), time);
}

void SpectrumStudy::keep_without_sweep() { session_.keep(start_->state, time_of(start_->state)); }

void SpectrumStudy::write_sweep_table() {
  directory_.write_file("sweep.csv", sweep_table(spectrum_.observed, sweep_->points()));
}

void SpectrumStudy::find_peaks(bool complete) {
  if (!complete && !sweep_ && !unfinished_.frequencies.empty())
    result_.spectra.push_back(without_linearity(unfinished_));
  result_.resonances = resonances_of(result_.spectra, result_.observed);
  if (!complete) return;
  for (const std::string& line : missing_peaks(result_.spectra, result_.resonances, result_.observed))
    session_.warn(line);
  judge();
}

void SpectrumStudy::judge() {
  for (const scenario::Expectation& e : spectrum_.expectations) {
    const auto quantity = *peak_quantity(e.quantity, result_.observed);
    const std::string method = method_names[quantity.method];
    const bool left_out = std::find(left_out_.begin(), left_out_.end(), method) != left_out_.end();
    if (!has(method) && !left_out) continue;  // not asked for
    result_.verdicts.push_back(run::judged(e, value_of(quantity, result_.spectra, result_.resonances)));
  }
}

void SpectrumStudy::transfer(const StateTransfer& state) {
  std::vector<std::string> asked;
  for (const Method method : asked_) asked.push_back(method_names[std::size_t(method)]);
  state.rows("asked", "", asked);
  state.rows("left_out", "", left_out_);
  asked_.clear();
  for (const Method method : {Method::linear, Method::pulse, Method::sweep})
    if (std::find(asked.begin(), asked.end(), method_names[std::size_t(method)]) != asked.end())
      asked_.push_back(method);
  std::uint64_t count = result_.spectra.size();
  state.value("count", "1", count, stored::at_most(std::size(method_names)));
  result_.spectra.resize(count);
  const std::size_t observed = result_.observed.size();
  for (std::size_t k = 0; k < count; ++k) {
    const StateTransfer of_method = state.below("road_" + std::to_string(k));
    result_.spectra[k].transfer(of_method, observed);
    if (result_.spectra[k].frequencies.empty()) of_method.refuse("frequencies", "has none");
  }
  unfinished_.transfer(state.below("unfinished"), observed);
}

}  // namespace

Measurement measure(const scenario::Plan& plan, const MeasurementOptions& options) {
  const auto spectrum = read_spectrum(plan);
  if (!spectrum)
    throw Error(fmt::format(
        "{}: has no [spectrum]; add one with drive, amplitude, observe, from_hz, to_hz and step_hz",
        plan.source.string()));
  run::Session session(run::spectrum_results, plan, run::session_options(options));
  SpectrumStudy study(plan, *spectrum, options, session);
  session.begin(study);
  return study.result();
}

Measurement resume_measurement(const MeasurementOptions& options, PluginHost& host) {
  return files::in_place([&] {
    run::Unfinished from = run::unfinished_in(options.out, run::spectrum_results, host, options.on_warning);
    const auto spectrum = read_spectrum(from.plan);
    if (!spectrum)
      throw Error(fmt::format("{}: its scenario has no [spectrum]; take a state that scree has written there",
                              (from.directory.path() / run::spectrum_results.state).string()));
    run::Session session(run::spectrum_results, from.plan, run::session_options(options),
                         std::move(from.directory));
    SpectrumStudy study(from.plan, *spectrum, options, session);
    session.resume(study, from.state, from.file);
    return study.result();
  });
}

}  // namespace scree::spectrum
