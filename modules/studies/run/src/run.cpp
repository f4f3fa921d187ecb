#include "drive.hpp"
#include "final_packing.hpp"
#include "pictures.hpp"
#include "results.hpp"
#include "run_from.hpp"
#include "sampler.hpp"
#include "scenario_file.hpp"
#include "state_writer.hpp"
#include "stopwatch.hpp"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/files/text.hpp>
#include <scree/files/try_each.hpp>
#include <scree/run/run.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/spare_room.hpp>
#include <scree/run/warnings.hpp>

namespace scree::run {

namespace {

constexpr const char* final_packing = "final_packing.csv";

Progress progress_of(const Simulation& simulation, const StageRunner& runner, double wall) {
  const Stage& stage = runner.stages()[runner.current()];
  return {runner.progress(),
          wall,
          simulation.time(),
          stage.name,
          runner.current() + 1,
          runner.stages().size(),
          runner.kinetic_over_elastic(),
          stage.kinetic_over_elastic};
}

class Run {
 public:
  // from: where the run in the directory goes on; nothing for a new run.
  Run(const scenario::Plan& plan, const RunOptions& options, RunDirectory& directory,
      std::optional<Resumed> from, Place place)
      : plan_(plan),
        options_(options),
        directory_(directory),
        place_(place),
        simulation_(from ? std::move(from->simulation) : set_up(plan, options.threads)),
        sampler_(plan),
        pictures_(plan, directory_),
        results_(plan, options, directory_, *simulation_),
        states_(plan.checkpoint, directory_, *simulation_, results_, watch_,
                [this] { return save_state(); }) {
    if (from) restore(from->state);
  }

  RunResult execute() {
    const std::vector<std::string> warnings =
        runner_ ? std::vector<std::string>() : start_warnings(plan_, *simulation_);
    results_.note(warnings);
    runner_ ? reopen() : prepare();
    if (options_.on_start) options_.on_start(*simulation_);
    if (options_.on_warning)
      for (const std::string& warning : warnings) options_.on_warning(warning);
    try {
      loop();
      watch_.time_output([&] {
        save();
        pictures_.draw_charts(sampler_, [this](const std::string& line) { results_.warn(line); });
      });
      results_.judge(sampler_);
      if (!results_.interrupted())
        for (const std::string& warning : sampler_.unfilled()) results_.warn(warning);
      if (no_final_state_) std::rethrow_exception(no_final_state_);
    } catch (const Error& error) {
      fail(files::record_line(error, place_ == Place::same));
      directory_.check_in_place();  // a better reason than the file that could not be written
      files::rethrow_as_failure(error);
    } catch (const std::exception& error) {
      fail(error.what());
      throw;
    }
    for (const std::string& warning : result_warnings(*simulation_)) results_.warn(warning);
    room_.release();
    results_.record(results_.interrupted() ? "interrupted" : "finished", "", watch_);
    return results_.result();
  }

  // Hooks of drive().
  void begin(const std::string& stage) {
    results_.begin_stage(stage);
    sampler_.begin_stage(results_.stages());
    check_step(plan_, *simulation_);
  }

  std::uint64_t observe(const std::string& stage, std::uint64_t steps) {
    return watch_.time_output([&] {
      return std::min({sampler_.sample(*simulation_, stage, steps), pictures_.take(*simulation_, steps),
                       states_.next(steps)});
    });
  }

  bool proceed(const StageRunner& runner) {
    report_progress(runner);
    return !stopped();
  }

  bool pauses(const StageRunner&) const { return states_.is_waiting(); }

  void between(const StageRunner& runner) {
    if (!runner.finished() && !stopped()) watch_.time_output([&] { states_.write_due(); });
  }

 private:
  // If the first files cannot be written, the directory is removed again.
  void prepare() {
    directory_.create();
    try {
      directory_.add("run.json");  // first, so that the list is known as that of a run
      // A run that is killed goes on from its text even before its first state.
      directory_.write_file(scenario_file, plan_.text_for_any_folder);
      results_.record("running", "", watch_);
      room_.reserve(directory_, "run.json");
      directory_.add(final_packing);
      for (const scenario::ProbePlan& probe : plan_.probes) directory_.add("series/" + probe.name + ".csv");
      sampler_.open(directory_.series());
    } catch (const std::exception&) {
      sampler_.close();  // too many open files cannot be removed
      directory_.discard();
      throw;
    }
  }

  void restore(const State& state) {
    const StateTransfer from = StateTransfer::restoring_from(state).below("run");
    runner_.emplace(*simulation_, plan_.stages, from.below("stages"));
    sampler_.transfer(from.below("probes"));
    sampler_.check_restored(*simulation_);
    pictures_.transfer(from.below("pictures"));
    results_.transfer(from.below("results"));
    results_.go_on_with_times();
    from.value("written", "1", written_);
    std::string scenario;
    from.value("scenario", "", scenario);
    prolonged_ = scenario != plan_.resolved_text;
  }

  // Continues the files of the run; what it wrote after the state is dropped, once all files are known to fit.
  void reopen() {
    sampler_.reopen(directory_.series(), results_.stages());
    directory_.create();
    room_.reserve(directory_, "run.json");
    directory_.written().return_to(written_);
    states_.remove_later();
    sampler_.cut();
    results_.record("running", "", watch_);
    if (!plan_.text_for_any_folder.empty()) directory_.write_file(scenario_file, plan_.text_for_any_folder);
    // Its scenario is that of the state from which the run goes on should it be killed.
    if (prolonged_) states_.write_checkpoint(), states_.finish();
  }

  // But what does not change, which the writer adds. The list of files must contain that of the state already.
  State save_state() {
    State state = simulation_->changing_state();
    const StateTransfer to = StateTransfer::saving_to(state).below("run");
    std::string scenario = plan_.resolved_text;
    to.value("scenario", "", scenario);
    runner_->save(to.below("stages"));
    sampler_.flush();
    sampler_.transfer(to.below("probes"));
    pictures_.transfer(to.below("pictures"));
    results_.transfer(to.below("results"));
    written_ = directory_.written().size();
    to.value("written", "1", written_);
    return state;
  }

  void loop() {
    watch_ = {};
    const std::string last = drive_stages();
    if (!runner_->finished()) results_.interrupt();
    results_.end_stage(results_.interrupted() ? "interrupted" : "");
    watch_.time_output([&] {
      if (results_.interrupted())
        states_.write_checkpoint();
      else
        write_final_state();
      states_.finish();
      sampler_.sample_last(*simulation_, last);
    });
  }

  // A state that cannot be written fails the run after all else has been saved.
  void write_final_state() {
    try {
      states_.write_final();
    } catch (const std::exception&) {
      no_final_state_ = std::current_exception();
    }
  }

  // Returns the name of the last stage.
  std::string drive_stages() {
    if (!runner_) return drive(runner_.emplace(*simulation_, plan_.stages), *this);
    // Killed behind its last state.
    if (runner_->finished()) return plan_.stages.back().name;
    const std::uint64_t steps = runner_->steps();
    const std::string stage = plan_.stages[runner_->current()].name;
    return drive(*runner_, *this,
                 std::min({sampler_.next(*simulation_, stage, steps), pictures_.next(*simulation_, steps),
                           states_.next(steps)}));
  }

  bool stopped() const { return options_.stop && *options_.stop; }

  void report_progress(const StageRunner& runner) {
    constexpr std::uint64_t steps_between_checks = 32;
    constexpr double seconds_between_reports = 0.2;
    if (simulation_->steps() % steps_between_checks) return;
    const double wall = watch_.total();
    if (wall - last_report_ < seconds_between_reports) return;
    last_report_ = wall;
    directory_.check_in_place();
    sampler_.flush();
    states_.look_at_clock();
    if (options_.on_progress && !runner.finished())
      options_.on_progress(progress_of(*simulation_, runner, wall));
  }

  void save() {
    sampler_.flush();
    pictures_.take_last(*simulation_);
    write_final_packing(*simulation_, directory_.add(final_packing));
  }

  // Saves what can be saved. Further errors are discarded, so that the user sees the original one.
  void fail(const std::string& reason) {
    results_.end_stage("failed");
    room_.release();
    files::try_each([&] { results_.record("failed", files::one_line(reason, 2000), watch_); },
                    [&] { sampler_.flush(); },
                    [&] { write_final_packing(*simulation_, directory_.add(final_packing)); },
                    [&] { pictures_.take_last(*simulation_); });
  }

  const scenario::Plan& plan_;
  const RunOptions& options_;
  RunDirectory& directory_;
  const Place place_;
  std::unique_ptr<Simulation> simulation_;
  SpareRoom room_;
  Sampler sampler_;
  Pictures pictures_;
  Results results_;
  std::optional<StageRunner> runner_;
  Stopwatch watch_;
  StateWriter states_;
  bool prolonged_ = false;     // its stages are longer than in the state from which it goes on
  std::uint64_t written_ = 0;  // see WrittenFiles::size
  double last_report_ = 0;     // (s) of wall time
  std::exception_ptr no_final_state_;
};

}  // namespace

RunResult run_from(std::optional<Resumed> from, const scenario::Plan& plan, const RunOptions& options,
                   RunDirectory& directory, Place place) {
  return Run(plan, options, directory, std::move(from), place).execute();
}

RunResult run_plan(const scenario::Plan& plan, const RunOptions& options) {
  require_stages(plan);
  RunDirectory directory = RunDirectory::of_results(options.out, options.overwrite, plan.source, plan.inputs);
  directory.report_lock(options.on_warning);
  return run_from(std::nullopt, plan, options, directory, Place::free);
}

}  // namespace scree::run
