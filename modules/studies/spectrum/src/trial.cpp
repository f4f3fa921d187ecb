#include "linear.hpp"
#include "pulse.hpp"
#include "start.hpp"
#include "sweep.hpp"

#include <chrono>

#include <scree/error.hpp>
#include <scree/run/run_stages.hpp>
#include <scree/run/set_up.hpp>
#include <scree/spectrum/trial.hpp>

namespace scree::spectrum {

namespace {

std::vector<RoadSpectrum> taken(Road road, const Start& start) {
  if (road == Road::linear) return {linear_spectrum(start)};
  if (road == Road::pulse) return {pulse_spectrum(start)};
  Sweep sweep(start);
  sweep.run([] {});
  return sweep.spectra();
}

// The state behind the stages, whose steps are added; nothing if it was stopped.
std::optional<State> after_stages(Simulation& simulation, const scenario::Plan& plan,
                                  const std::atomic<bool>* stop, std::uint64_t& steps) {
  const std::uint64_t before = simulation.steps();
  StageRunner runner(simulation, plan.stages);
  const auto proceed = [stop] { return !(stop && *stop); };
  if (!run::run_stages(runner, proceed, [](double, const std::string&) {})) return std::nullopt;
  steps += simulation.steps() - before;
  return simulation.state();
}

}  // namespace

SpectrumTrial try_roads(const scenario::Plan& plan, const std::vector<Road>& roads,
                        const std::atomic<bool>* stop) {
  using Clock = std::chrono::steady_clock;
  SpectrumTrial trial;
  if (const auto problem = scenario::sampling_problem(plan.spectrum->to_hz, plan.scene.step))
    throw Error(*problem + "; give a shorter step");
  auto simulation = run::set_up(plan);
  if (!plan.stages.empty()) check_before_stages(plan, roads);
  const auto began = Clock::now();
  std::optional<State> state = after_stages(*simulation, plan, stop, trial.steps);
  simulation.reset();
  trial.stopped = !state;
  if (trial.stopped) return trial;
  const Start start{plan, scene_in_stage(plan.scene, plan.stages, plan.stages.size()), std::move(*state),
                    stop};
  try {
    for (const Road road : roads)
      for (RoadSpectrum& spectrum : taken(road, start)) trial.roads.push_back(std::move(spectrum));
  } catch (const Error& error) {
    if (error.status() != ExitStatus::interrupted) throw;
  }
  trial.stopped = !start.proceeds();
  for (const RoadSpectrum& road : trial.roads) trial.steps += road.steps;
  trial.resonances = resonances_of(trial.roads, plan.spectrum->observed);
  trial.wall = std::chrono::duration<double>(Clock::now() - began).count();
  return trial;
}

}  // namespace scree::spectrum
