#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <scree/scenario/plan.hpp>
#include <scree/stage.hpp>

namespace scree::run {

// Runs a simulation through its stages, or the rest of them, until they end or hooks.proceed(runner) returns
// false. resumed_next: the runner has begun already, and output is due at this step of its stage. Returns the
// name of the last stage. The hooks:
//   begin(stage)             before the first step of each stage
//   observe(stage, steps)    takes what is due `steps` after the start of the stage: at its start, its end and
//                            the step that the last call returned. Returns the step at which more is due
//   proceed(runner)          polled during each step
//   pauses(runner)           polled likewise: true ends the steps early, so that between() is called
//   between(runner)          before steps and after the last, when nothing is under way: a state saved here
//                            goes on as if the run had not stopped
template <class Hooks>
std::string run_with_hooks(StageRunner& runner, Hooks&& hooks,
                           std::optional<std::uint64_t> resumed_next = {}) {
  std::size_t stage = runner.current();
  std::uint64_t steps = 0, next = 0;
  const auto name = [&] { return runner.stages()[stage].name; };
  const auto start = [&] {
    hooks.begin(name());
    next = hooks.observe(name(), steps = 0);
  };
  if (resumed_next)
    steps = runner.steps(), next = *resumed_next;
  else
    start();
  while (!runner.finished() && hooks.proceed(runner)) {
    hooks.between(runner);
    steps += runner.run(next - steps, [&] { return hooks.proceed(runner) && !hooks.pauses(runner); });
    next = hooks.observe(name(), steps);
    if (runner.current() == stage || runner.finished()) continue;
    stage = runner.current();
    start();
  }
  hooks.between(runner);
  return name();
}

// A runner of the stages of a plan, from their start or, with `state`, from where it was saved. If conditions
// read columns of probes it has these probes, without series; the plan must outlive it then.
StageRunner stage_runner(Simulation& simulation, const scenario::Plan& plan);
StageRunner stage_runner(Simulation& simulation, const scenario::Plan& plan, const StateTransfer& state);

// Takes a simulation from its present stage to the start of the stage `end`, without probes and output.
// `proceed` is polled in each step, `on_progress` called every thousand steps with the share of all stages
// and the name of this one. Returns false if `proceed` ends it. Throws Error as Simulation::step().
bool run_stages(StageRunner& runner, std::size_t end, const std::function<bool()>& proceed,
                const std::function<void(double share, const std::string& stage)>& on_progress);

}  // namespace scree::run
