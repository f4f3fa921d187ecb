#include "linear.hpp"
#include "pulse.hpp"
#include "start.hpp"
#include "sweep.hpp"

#include <chrono>

#include <scree/error.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/stage_loop.hpp>
#include <scree/scenario/drive_sampling.hpp>
#include <scree/spectrum/spectrum_in_memory.hpp>

namespace scree::spectrum {

namespace {

std::vector<MethodSpectrum> measured(Method method, const Start& start) {
  if (method == Method::linear) return {linear_spectrum(start)};
  if (method == Method::pulse) return {pulse_spectrum(start)};
  Sweep sweep(start);
  sweep.run([] {});
  return sweep.spectra();
}

// The state after the stages, whose steps are added; nothing if it was stopped.
std::optional<State> after_stages(Simulation& simulation, const scenario::Plan& plan,
                                  const std::atomic<bool>* stop, std::uint64_t& steps) {
  const std::uint64_t before = simulation.steps();
  StageRunner runner = run::stage_runner(simulation, plan);
  const auto proceed = [stop] { return !(stop && *stop); };
  if (!run::run_stages(runner, plan.stages.size(), proceed, [](double, const std::string&) {}))
    return std::nullopt;
  steps += simulation.steps() - before;
  return simulation.state();
}

}  // namespace

InMemorySpectrum spectrum_in_memory(const scenario::Plan& plan, const SpectrumPlan& spectrum_plan,
                                    const std::vector<Method>& methods, const std::atomic<bool>* stop) {
  using Clock = std::chrono::steady_clock;
  InMemorySpectrum found;
  if (const auto problem = scenario::sampling_problem(spectrum_plan.to_hz, plan.scene.step))
    throw Error(*problem + "; give a shorter step");
  auto simulation = run::set_up(plan);
  if (!plan.stages.empty()) check_before_stages(plan, spectrum_plan, methods);
  const auto began = Clock::now();
  std::optional<State> state = after_stages(*simulation, plan, stop, found.steps);
  simulation.reset();
  found.stopped = !state;
  if (found.stopped) return found;
  const Start start{plan, spectrum_plan, scene_in_stage(plan.scene, plan.stages, plan.stages.size()),
                    std::move(*state), stop};
  try {
    for (const Method method : methods)
      for (MethodSpectrum& spectrum : measured(method, start)) found.spectra.push_back(std::move(spectrum));
  } catch (const Error& error) {
    if (error.status() != ExitStatus::interrupted) throw;
  }
  found.stopped = !start.proceeds();
  for (const MethodSpectrum& spectrum : found.spectra) found.steps += spectrum.steps;
  found.peaks = peaks_in(found.spectra, spectrum_plan.observed);
  found.wall_time = std::chrono::duration<double>(Clock::now() - began).count();
  return found;
}

}  // namespace scree::spectrum
