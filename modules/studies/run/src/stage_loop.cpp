#include "sampler.hpp"

#include <algorithm>

#include <scree/run/stage_loop.hpp>

namespace scree::run {

namespace {

// Probes without series, which are saved with the runner.
class Columns : public Sampler {
 public:
  using Sampler::Sampler;
  void transfer(const StateTransfer& state) override { transfer_probes(state); }
};

std::shared_ptr<Columns> columns_of(const scenario::Plan& plan) {
  const bool any = std::any_of(plan.stages.begin(), plan.stages.end(),
                               [](const Stage& stage) { return stage.until.reads_columns(); });
  return any ? std::make_shared<Columns>(plan) : nullptr;
}

}  // namespace

StageRunner stage_runner(Simulation& simulation, const scenario::Plan& plan) {
  return {simulation, plan.stages, columns_of(plan)};
}

StageRunner stage_runner(Simulation& simulation, const scenario::Plan& plan, const StateTransfer& state) {
  const auto columns = columns_of(plan);
  StageRunner runner(simulation, plan.stages, state, columns);
  if (columns) columns->check_restored(simulation);
  return runner;
}

bool run_stages(StageRunner& runner, std::size_t end, const std::function<bool()>& proceed,
                const std::function<void(double share, const std::string& stage)>& on_progress) {
  constexpr std::uint64_t steps_between_reports = 1000;
  while (runner.current() < end) {
    if (!proceed()) return false;
    runner.run(steps_between_reports, proceed);
    if (!runner.finished())
      on_progress(runner.progress().value_or(0), runner.stages()[runner.current()].name);
  }
  return true;
}

}  // namespace scree::run
