#include "driven_walls.hpp"
#include "linear.hpp"
#include "observer.hpp"
#include "pulse.hpp"
#include "spectrum_study.hpp"
#include "start.hpp"

#include <fmt/format.h>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/stage_loop.hpp>

namespace scree::spectrum {

namespace {

constexpr double seconds_between_tables = 1;

}  // namespace

bool SpectrumStudy::work() {
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

void SpectrumStudy::prepare() {
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
    if (session_.wall_time() - last_table_ < seconds_between_tables) return;
    last_table_ = session_.wall_time();
    write_sweep_table();
  });
  write_sweep_table();
  for (MethodSpectrum& method : sweep_->spectra()) {
    for (const std::string& note : method.notes) session_.warn(note);
    result_.spectra.push_back(std::move(method));
  }
}

void SpectrumStudy::write_sweep_table() {
  directory_.write_file("sweep.csv", sweep_table(spectrum_.observed, sweep_->points()));
}

void SpectrumStudy::find_peaks(bool complete) {
  if (!complete && !sweep_ && !unfinished_.frequencies.empty())
    result_.spectra.push_back(without_linearity(unfinished_));
  result_.peaks = peaks_in(result_.spectra, result_.observed);
  if (!complete) return;
  for (const std::string& line : missing_peaks(result_.spectra, result_.peaks, result_.observed))
    session_.warn(line);
  judge();
}

void SpectrumStudy::judge() {
  for (const scenario::Expectation& e : spectrum_.expectations) {
    const auto quantity = *peak_quantity(e.quantity, result_.observed);
    const std::string method = method_names[quantity.method];
    const bool left_out = std::find(left_out_.begin(), left_out_.end(), method) != left_out_.end();
    if (!has(method) && !left_out) continue;  // not asked for
    result_.verdicts.push_back(run::judged(e, value_of(quantity, result_.spectra, result_.peaks)));
  }
}

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

}  // namespace scree::spectrum
