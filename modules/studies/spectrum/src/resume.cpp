#include "spectrum_study.hpp"

#include <fmt/format.h>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/stage_loop.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/state_transfer.hpp>

// States of measurements, and measurements that go on from them.

namespace scree::spectrum {

void SpectrumStudy::keep_in_stages() {
  State state = simulation_->state();
  stages_->save(StateTransfer::saving_to(state).below(run::spectrum_results.group).below("stages"));
  session_.keep(std::move(state), simulation_->time());
}

void SpectrumStudy::keep_sweep() {
  State state = sweep_->save();
  const double time = time_of(state);
  session_.keep(std::move(state), time);
}

void SpectrumStudy::keep_without_sweep() { session_.keep(start_->state, time_of(start_->state)); }

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
    const StateTransfer of_method = state.below("method_" + std::to_string(k));
    result_.spectra[k].transfer(of_method, observed);
    if (result_.spectra[k].frequencies.empty()) of_method.refuse("frequencies", "has none");
  }
  unfinished_.transfer(state.below("unfinished"), observed);
}

void SpectrumStudy::restore(const State& state) {
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
