#include "horizon.hpp"

#include <algorithm>
#include <cmath>

#include <scree/run/run_in_memory.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/stage_loop.hpp>

namespace scree::accuracy {

namespace {

constexpr int max_comparisons = 1000;  // over the whole run

// One of the two simulations.
class ComparedRun {
 public:
  ComparedRun(scenario::Plan plan, double step)
      : plan_(with_step(std::move(plan), step)),
        simulation_(run::set_up(plan_)),
        runner_(run::stage_runner(*simulation_, plan_)) {}

  void run_until(double time, const std::atomic<bool>* stop) {
    while (!runner_.finished() && simulation_->time() < time - 0.5 * simulation_->step_length() &&
           !(stop && *stop))
      runner_.step();
  }
  bool finished() const { return runner_.finished(); }
  std::vector<Vec3> positions() const { return run::unwrapped_positions(*simulation_); }

 private:
  static scenario::Plan with_step(scenario::Plan plan, double step) {
    plan.scene.step = step;
    return plan;
  }

  scenario::Plan plan_;
  std::unique_ptr<Simulation> simulation_;
  StageRunner runner_;
};

}  // namespace

double longest_duration(const scenario::Plan& plan) {
  double sum = 0;
  for (const Stage& stage : plan.stages)
    sum += stage.duration.value_or(stage.until.at_most.value_or(stage.until.at_least));
  return sum;
}

double distance_between(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i] - b[i], a[i] - b[i]);
  return a.empty() ? 0 : std::sqrt(sum / double(a.size()));
}

std::optional<double> trustworthy_until(const scenario::Plan& plan, double step, double interval,
                                        double distance, const std::function<void(double)>& on_progress,
                                        const std::atomic<bool>* stop) {
  ComparedRun coarse(plan, step), fine(plan, 0.5 * step);
  const double end = longest_duration(plan),
               between = interval * std::max(1.0, std::round(end / max_comparisons / interval));
  for (int k = 1; (k - 1) * between < end; ++k) {
    coarse.run_until(k * between, stop);
    fine.run_until(k * between, stop);
    if (stop && *stop) break;
    // Runs that end by a condition may end at different times.
    if (coarse.finished() || fine.finished()) break;
    if (distance_between(coarse.positions(), fine.positions()) > distance) return (k - 1) * between;
    if (on_progress) on_progress(std::min(1.0, k * between / end));
  }
  return std::nullopt;
}

}  // namespace scree::accuracy
