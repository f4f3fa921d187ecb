#include "comparison.hpp"
#include "horizon.hpp"
#include "orders.hpp"
#include "reference.hpp"
#include "steps.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/accuracy/report.hpp>
#include <scree/accuracy/study.hpp>
#include <scree/error.hpp>
#include <scree/run/run_in_memory.hpp>
#include <scree/run/session.hpp>
#include <scree/told_apart.hpp>

namespace scree::accuracy {

namespace {

using run::InMemoryRun;
using scenario::Plan;

Plan with(Plan plan, const Setting& setting) {
  plan.scene.step = setting.step;
  plan.scene.integration = setting.integration;
  return plan;
}

class StudyRunner {
 public:
  StudyRunner(const Plan& plan, const StudyOptions& options)
      : comparison_(plan, options.quantities), plan_(comparison_.plan()), options_(options) {
    coarsest_ = fitting_step(plan_, options.coarsest * plan_.scene.step);
    finest_ = std::ldexp(coarsest_, 1 - options.count);
    // Unit of work for the progress: a run with the finest step.
    all_work_ = 3 + 14 + evaluations_of_all();
  }

  // The reference, with which all settings are compared.
  void make_reference() {
    found_.tolerance = options_.tolerance;
    found_.of_peaks = comparison_.of_peaks();
    check_length();
    if (!found_.of_peaks) find_horizon();
    run_references();
    note_ends();
  }

  void run_settings() {
    for (const Integration integration : chosen())
      for (int k = 0; k < options_.count && !stopped(); ++k)
        run_setting({integration, std::ldexp(coarsest_, -k)});
    summarise_methods(found_);
    found_.interrupted = stopped();
  }

  const Convergence& found() const { return found_; }

 private:
  std::vector<Integration> chosen() const {
    if (!options_.integrations.empty()) return options_.integrations;
    std::vector<Integration> all;
    for (const IntegrationTraits& traits : integrations()) all.push_back(traits.integration);
    return all;
  }
  double evaluations_of_all() const {
    double sum = 0;
    for (const Integration integration : chosen()) sum += 2 * traits_of(integration).evaluations;
    return sum;
  }
  bool stopped() const { return options_.stop && *options_.stop; }

  void report_progress(double work, const std::string& what) {
    if (options_.on_progress) options_.on_progress((done_ + work) / all_work_, what);
  }
  void count(double work) { done_ += work; }

  void find_horizon() {
    // The extrapolation is more accurate than its runs, so a strict tolerance does not require more of them.
    constexpr double min_distance = 1e-5;
    const double distance = std::max(0.1 * options_.tolerance, min_distance) * mean_radius(plan_);
    const auto until = trustworthy_until(
        with(plan_, {Integration::velocity_verlet, finest_}), finest_, coarsest_, distance,
        [&](double fraction) { report_progress(3 * fraction, "trustworthy time of the reference"); },
        options_.stop);
    count(3);
    if (!until) return;
    if (*until <= 0)
      throw Error(fmt::format(
          "steps of {:g} and {:g} s diverge before they can be compared; give a smaller --coarsest "
          "or a larger --count or --tolerance",
          finest_, 0.5 * finest_));
    found_.horizon = until_ = *until;
  }

  // Limit of the total work.
  void check_length() const {
    constexpr double max_steps = 1e10;
    const double steps = 8 * longest_duration(plan_) / finest_;
    const auto [shown, bound] = told_apart(steps, max_steps, 3);
    if (steps > max_steps)
      throw Error(
          fmt::format("the finest reference of {:g} s would take {} steps; give a larger --coarsest or a "
                      "smaller --count, for at most {}",
                      finest_ / 8, shown, bound));
  }

  void note_ends() {
    bool by_condition = false;
    for (const Stage& stage : plan_.stages) by_condition |= !stage.duration;
    if (until_ < std::numeric_limits<double>::infinity()) return;
    if (by_condition)
      found_.notes.push_back(
          "Stages end by a condition at times that depend on the step; errors include this.");
    else if (!divides_durations(plan_, coarsest_))
      found_.notes.push_back(
          "No step divides all durations of the stages; errors include the rounding of their ends.");
  }

  void run_references() {
    std::vector<InMemoryRun> runs;
    for (int k = 1; k <= 3 && !stopped(); ++k) {
      report_progress(0, "reference");
      const Setting setting = {Integration::velocity_verlet, std::ldexp(finest_, -k)};
      runs.push_back(comparison_.run(with(plan_, setting), until_, options_.stop));
      count(std::ldexp(1, k));
    }
    if (runs.size() < 3 || runs.back().stopped)
      throw Error("interrupted before the reference was complete", ExitStatus::interrupted);
    std::vector<std::string> without;
    compared_ = compared_expectations(plan_, runs, without);
    for (const std::string& name : without)
      found_.notes.push_back(
          fmt::format("{} has no value{} and is excluded.", name, found_.horizon ? " before that time" : ""));
    found_.quantities = reference_quantities(plan_, runs, compared_, found_.horizon.has_value());
    exclude_uncertain();
    if (!found_.of_peaks) add_positions(runs);
    if (found_.quantities.empty())
      throw Error(fmt::format("nothing is left to compare ({}); choose other quantities",
                              found_.notes.empty() ? "there are no quantities" : found_.notes.back()));
    found_.duration = runs.back().time;
  }

  void add_positions(const std::vector<InMemoryRun>& runs) {
    ReferencePositions reference = reference_positions(runs);
    found_.quantities.push_back({"positions", 0, reference.uncertainty / mean_radius(plan_), 1, false});
    reference_positions_ = std::move(reference.positions);
  }

  // Excludes quantities whose reference is less accurate than its scale.
  void exclude_uncertain() {
    for (std::size_t k = compared_.size(); k-- > 0;) {
      const Quantity& q = found_.quantities[k];
      if (q.closed_form || !(q.uncertainty >= q.scale())) continue;
      found_.notes.push_back(
          fmt::format("{} is excluded: its reference {:.3g} has an uncertainty of {:.3g}; give its "
                      "[[expect]] a scale.",
                      q.name, q.reference, q.uncertainty));
      found_.quantities.erase(found_.quantities.begin() + std::ptrdiff_t(k));
      compared_.erase(compared_.begin() + std::ptrdiff_t(k));
    }
  }

  // Minimum wall time of a few runs, to reduce the influence of other load on the machine.
  InMemoryRun timed(const Plan& plan) {
    constexpr int max_repeats = 5;
    constexpr double enough = 0.2;  // (s) of wall time
    InMemoryRun best = comparison_.run(plan, until_, options_.stop);
    double spent = best.wall_time;
    for (int n = 1; n < max_repeats && spent < enough && !stopped(); ++n) {
      const InMemoryRun again = comparison_.run(plan, until_, options_.stop);
      if (again.stopped) break;
      spent += again.wall_time;
      best.wall_time = std::min(best.wall_time, again.wall_time);
    }
    return best;
  }

  void run_setting(const Setting& setting) {
    report_progress(0, fmt::format("{}, step {:.3g} s", traits_of(setting.integration).name, setting.step));
    SettingResult outcome;
    outcome.setting = setting;
    try {
      const InMemoryRun run = timed(with(plan_, setting));
      if (run.stopped) return;
      outcome.wall_time = run.wall_time;
      outcome.steps = run.steps;
      compare(run, outcome);
    } catch (const Error& error) {
      outcome.problem = error.problem();
    }
    found_.outcomes.push_back(std::move(outcome));
    count(traits_of(setting.integration).evaluations * finest_ / setting.step);
  }

  void compare(const InMemoryRun& run, SettingResult& outcome) const {
    for (const std::size_t k : compared_) outcome.values.push_back(run.quantities[k]);
    if (!found_.of_peaks)
      outcome.values.push_back(distance_between(run.positions, reference_positions_) / mean_radius(plan_));
    for (std::size_t k = 0; k < found_.quantities.size(); ++k)
      outcome.errors.push_back(std::abs(outcome.values[k] - found_.quantities[k].reference) /
                               found_.quantities[k].scale());
    for (std::size_t k = 0; k < found_.quantities.size(); ++k)
      if (!std::isfinite(outcome.errors[k])) outcome.problem = found_.quantities[k].name + " is not a number";
  }

  const Comparison comparison_;
  const Plan& plan_;
  const StudyOptions& options_;
  Convergence found_;
  std::vector<Vec3> reference_positions_;
  std::vector<std::size_t> compared_;  // expectations
  double coarsest_ = 0, finest_ = 0;
  double until_ = std::numeric_limits<double>::infinity();
  double done_ = 0, all_work_ = 1;
};

// A study with a directory.
class RecordedStudy : public run::Study {
 public:
  RecordedStudy(const Plan& plan, const RecordedStudyOptions& options, run::Session& session)
      : title_(plan.heading()), options_(options), session_(session), runner_(plan, options) {}

  void prepare() override { runner_.make_reference(); }

  bool work() override {
    runner_.run_settings();
    if (options_.on_result) options_.on_result(runner_.found());
    write_table(runner_.found(), session_.directory());
    try {
      draw_charts(runner_.found(), title_, session_.directory());
    } catch (const std::exception& error) {
      session_.warn(fmt::format("the charts were not drawn: {}", error.what()));
    }
    return !runner_.found().interrupted;
  }

  void save_failed() override { write_table(runner_.found(), session_.directory()); }
  nlohmann::ordered_json record() override { return record_of(runner_.found()); }
  nlohmann::ordered_json options() const override { return json_of(options_); }

  const Convergence& found() const { return runner_.found(); }

 private:
  std::string title_;
  const RecordedStudyOptions& options_;
  run::Session& session_;
  StudyRunner runner_;
};

}  // namespace

Convergence study(const scenario::Plan& plan, const StudyOptions& options) {
  StudyRunner runner(plan, options);
  runner.make_reference();
  runner.run_settings();
  return runner.found();
}

std::pair<Convergence, std::filesystem::path> recorded_study(const scenario::Plan& plan,
                                                             const RecordedStudyOptions& options) {
  run::Session session(run::accuracy_results, plan,
                       {options.out, options.overwrite, {}, options.on_warning, options.stop});
  RecordedStudy study(plan, options, session);
  session.begin(study);
  return {study.found(), session.directory().path()};
}

}  // namespace scree::accuracy
