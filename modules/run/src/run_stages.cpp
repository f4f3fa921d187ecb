#include <scree/error.hpp>
#include <scree/run/run_stages.hpp>

namespace scree::run {

void run_stages(Simulation& simulation, const std::vector<Stage>& stages,
                const std::function<bool()>& proceed,
                const std::function<void(double share, const std::string& stage)>& on_progress) {
  constexpr std::uint64_t steps_between_reports = 1000;
  StageRunner runner(simulation, stages);
  while (!runner.finished()) {
    if (!proceed()) throw Error("interrupted before the stages had ended", ExitStatus::interrupted);
    runner.run(steps_between_reports, proceed);
    if (!runner.finished())
      on_progress(runner.progress().value_or(0), runner.stages()[runner.current()].name);
  }
}

}  // namespace scree::run
