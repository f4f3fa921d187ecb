#include <scree/run/run_stages.hpp>

namespace scree::run {

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
