#include "sampler.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <scree/run/run_in_memory.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/stage_loop.hpp>
#include <scree/run/step_check.hpp>
#include <scree/run/verdict.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::run {

namespace {

std::vector<double> quantities_of(const scenario::Plan& plan, const Simulation& simulation,
                                  const Sampler& sampler) {
  const auto numbers = scenario::run_quantities(simulation);
  const auto column = [&](const std::string& probe, const std::string& name) {
    return sampler.series(probe).column(name);
  };
  std::vector<double> values;
  for (const scenario::Expectation& e : plan.expectations)
    values.push_back(judge_expectation(e, numbers, column).value);
  return values;
}

struct InMemoryHooks {
  const scenario::Plan& plan;
  const InMemoryOptions& options;
  const Simulation& simulation;
  Sampler& sampler;
  InMemoryRun& run;
  double end;  // (s)

  void begin(const std::string&) { check_step(plan, simulation); }
  std::uint64_t observe(const std::string& stage, std::uint64_t steps) {
    const double left = std::ceil((end - simulation.time()) / plan.scene.step);
    return std::min(sampler.take(simulation, stage, steps),
                    steps + std::uint64_t(std::clamp(left, 1.0, 1e15)));
  }
  bool proceed(const StageRunner&) {
    run.stopped = options.stop && *options.stop;
    return !run.stopped && simulation.time() < end;
  }
  bool pauses(const StageRunner&) const { return false; }
  void between(const StageRunner&) {}
};

}  // namespace

std::vector<Vec3> unwrapped_positions(const Simulation& s) {
  const Particles& p = s.particles();
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Vec3 x = p.body(i).position;
    for (int k = 0; k < p.dimension(); ++k)
      if (s.domain().periodic[std::size_t(k)]) x[k] += p.image[k][i] * s.domain().length(k);
    positions.push_back(x);
  }
  return positions;
}

InMemoryRun run_in_memory(const scenario::Plan& plan, const InMemoryOptions& options) {
  using Clock = std::chrono::steady_clock;
  require_stages(plan);
  const auto simulation = set_up(plan, options.threads);
  Sampler sampler(plan);
  sampler.open();
  StageRunner runner(*simulation, plan.stages, unowned(sampler));
  InMemoryRun run;
  // Half a step earlier, so that rounding does not add a step.
  const double end = options.until - 0.5 * plan.scene.step;
  const auto start = Clock::now();
  const std::string last =
      run_with_hooks(runner, InMemoryHooks{plan, options, *simulation, sampler, run, end});
  run.wall_time = std::chrono::duration<double>(Clock::now() - start).count();
  sampler.sample_last(*simulation, last);
  run.steps = simulation->steps();
  run.time = simulation->time();
  run.quantities = quantities_of(plan, *simulation, sampler);
  run.positions = unwrapped_positions(*simulation);
  return run;
}

}  // namespace scree::run
