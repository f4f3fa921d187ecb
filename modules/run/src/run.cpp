#include "checkpoints.hpp"
#include "drive.hpp"
#include "final_packing.hpp"
#include "pictures.hpp"
#include "results.hpp"
#include "run_from.hpp"
#include "sampler.hpp"
#include "spare_room.hpp"
#include "stopwatch.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/run/run.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/warnings.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::run {

namespace {

// Calls every function, even if others throw; exceptions are discarded.
template <class... Work>
void try_each(const Work&... work) {
  const auto attempt = [](const auto& one) {
    try {
      one();
    } catch (const std::exception&) {
    }
  };
  (attempt(work), ...);
}

RunDirectory directory_of(const scenario::Plan& plan, const RunOptions& options) {
  if (options.out.empty()) return RunDirectory::numbered(RunDirectory::default_for(plan.source));
  using Existing = RunDirectory::Existing;
  RunDirectory directory(options.out, options.overwrite ? Existing::replace : Existing::refuse);
  directory.protect(plan.inputs);
  directory.take();
  return directory;
}

constexpr const char* final_packing = "final_packing.csv";

// The simulation of a run that goes on, with the parameters of its present stage.
std::unique_ptr<Simulation> resumed(const scenario::Plan& plan, const State& state, unsigned threads) {
  const std::size_t stage = stage_of(StateTransfer::restoring_from(state).below("run/stages"));
  Scene scene = scene_in_stage(plan.scene, plan.stages, stage);
  scene.threads = threads;
  return std::make_unique<Simulation>(scene, state);
}

class Run {
 public:
  // state: that from which the run in the directory goes on; null for a new run.
  Run(const scenario::Plan& plan, const RunOptions& options, RunDirectory& directory, const State* state)
      : plan_(plan),
        options_(options),
        directory_(directory),
        checkpoints_(directory),
        simulation_(state ? resumed(plan, *state, options.threads) : set_up(plan, options.threads)),
        sampler_(plan),
        pictures_(plan, directory_),
        results_(plan, options, directory_, *simulation_) {
    if (state) restore(*state);
  }

  // Whether nothing is left to do.
  bool finished() const { return runner_ && runner_->finished(); }

  RunResult execute() {
    runner_ ? reopen() : prepare();
    if (options_.on_start) options_.on_start(*simulation_);
    if (!runner_)
      for (const std::string& warning : start_warnings(plan_, *simulation_)) results_.warn(warning);
    try {
      loop();
      watch_.time_output([&] {
        save();
        pictures_.draw_charts(sampler_, [this](const std::string& line) { results_.warn(line); });
      });
      results_.judge(sampler_);
    } catch (const Error& error) {
      fail(error.what());
      // The status bad_input is reserved for errors before anything is written.
      throw error.status() == ExitStatus::bad_input ? Error(error.what(), ExitStatus::failure) : error;
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
                       next_checkpoint(steps)});
    });
  }

  bool proceed(const StageRunner& runner) {
    report_progress(runner);
    return !stopped();
  }

  bool pauses(const StageRunner&) const { return checkpoint_due_; }

  void between(const StageRunner& runner) {
    if (runner.finished() || stopped() || !(checkpoint_due_ || checkpoint_due_now())) return;
    watch_.time_output([&] { write_checkpoint(); });
  }

 private:
  // If the first files cannot be written, the directory is removed again.
  void prepare() {
    directory_.create();
    try {
      results_.record("running", "", watch_);
      directory_.write_file("scenario.toml", plan_.text_for_any_folder);
      room_.reserve(directory_.add(SpareRoom::file_name),
                    SpareRoom::size + std::filesystem::file_size(directory_.path() / "run.json"));
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
    results_.transfer(from.below("results"), watch_);
    from.value("written", "1", written_);
    last_checkpoint_step_ = simulation_->steps();
  }

  // Continues the files of the run; what it wrote after the state is dropped, once all files are known to fit.
  void reopen() {
    sampler_.reopen(directory_.series(), results_.stages());
    directory_.create();
    directory_.written().return_to(written_);
    sampler_.cut();
    results_.record("running", "", watch_);
    if (!plan_.text_for_any_folder.empty()) directory_.write_file("scenario.toml", plan_.text_for_any_folder);
    reserve_room();
  }

  void reserve_room() {
    room_.reserve(directory_.add(SpareRoom::file_name),
                  SpareRoom::size + std::filesystem::file_size(directory_.path() / "run.json"));
  }

  // The list of files must contain that of the state already.
  State state() {
    State state = simulation_->state();
    const StateTransfer to = StateTransfer::saving_to(state).below("run");
    std::string scenario = plan_.resolved_text;
    to.value("scenario", "", scenario);
    runner_->save(to.below("stages"));
    sampler_.flush();
    sampler_.transfer(to.below("probes"));
    pictures_.transfer(to.below("pictures"));
    results_.transfer(to.below("results"), watch_);
    written_ = directory_.written().size();
    to.value("written", "1", written_);
    return state;
  }

  void loop() {
    std::optional<std::uint64_t> next;
    if (runner_) {
      const std::uint64_t steps = runner_->steps();
      const std::string stage = runner_->stages()[runner_->current()].name;
      next = std::min({sampler_.next(*simulation_, stage, steps), pictures_.next(*simulation_, steps),
                       next_checkpoint(steps)});
    } else {
      runner_.emplace(*simulation_, plan_.stages);
    }
    const std::string last = drive(*runner_, *this, next);
    if (!runner_->finished()) results_.interrupt();
    results_.end_stage(results_.interrupted() ? "interrupted" : "");
    watch_.time_output([&] {
      write_last_state();
      sampler_.sample_last(*simulation_, last);
    });
  }

  // Step count after the start of the stage at which a checkpoint is due by simulated time.
  std::uint64_t next_checkpoint(std::uint64_t steps) const {
    if (!plan_.checkpoint.every_time) return never;
    const std::uint64_t now = simulation_->steps(),
                        next = next_due(now, *plan_.checkpoint.every_time, simulation_->step_length());
    return next == never ? never : steps + (next - now);
  }

  bool checkpoint_due_now() const {
    const std::uint64_t steps = simulation_->steps();
    return plan_.checkpoint.every_time && steps > last_checkpoint_step_ &&
           is_due(steps, *plan_.checkpoint.every_time, simulation_->step_length());
  }

  void write_checkpoint() {
    checkpoint_due_ = false;
    last_checkpoint_step_ = simulation_->steps();
    try {
      const std::filesystem::path path = checkpoints_.add(simulation_->steps());
      checkpoints_.write(path, state());
      checkpoint_failed_ = false;
    } catch (const Error& error) {
      // One warning until one succeeds again: on a full disk each would lengthen run.json.
      if (!std::exchange(checkpoint_failed_, true))
        results_.warn(fmt::format("no checkpoint at t = {:g} s: {}", simulation_->time(), error.what()));
    }
    last_checkpoint_ = watch_.total();
  }

  void write_last_state() {
    if (results_.interrupted())
      write_checkpoint();
    else if (plan_.checkpoint.final_state)
      state_file::write_state(checkpoints_.add_final(), state());
  }

  bool stopped() const { return options_.stop && *options_.stop; }

  void report_progress(const StageRunner& runner) {
    constexpr std::uint64_t steps_between_checks = 32;
    constexpr double seconds_between_reports = 0.2;
    if (simulation_->steps() % steps_between_checks) return;
    const double wall = watch_.total();
    if (wall - last_report_ < seconds_between_reports) return;
    last_report_ = wall;
    sampler_.flush();
    checkpoint_due_ |= plan_.checkpoint.every && wall - last_checkpoint_ >= *plan_.checkpoint.every;
    if (options_.on_progress && !runner.finished()) options_.on_progress(progress_of(runner, wall));
  }

  Progress progress_of(const StageRunner& runner, double wall) const {
    const Stage& stage = runner.stages()[runner.current()];
    return {runner.progress(),
            wall,
            simulation_->time(),
            stage.name,
            runner.current() + 1,
            runner.stages().size(),
            runner.kinetic_over_elastic(),
            stage.kinetic_over_elastic};
  }

  void save() {
    sampler_.flush();
    pictures_.take_last(*simulation_);
    write_final_packing(*simulation_, directory_.path() / final_packing);
  }

  // Saves what can be saved. Further errors are discarded, so that the user sees the original one.
  void fail(const std::string& reason) {
    results_.end_stage("failed");
    room_.release();
    try_each([&] { results_.record("failed", files::one_line(reason, 2000), watch_); },
             [&] { sampler_.flush(); },
             [&] { write_final_packing(*simulation_, directory_.path() / final_packing); },
             [&] { pictures_.take_last(*simulation_); });
  }

  const scenario::Plan& plan_;
  const RunOptions& options_;
  RunDirectory& directory_;
  Checkpoints checkpoints_;
  std::unique_ptr<Simulation> simulation_;
  SpareRoom room_;
  Sampler sampler_;
  Pictures pictures_;
  Results results_;
  std::optional<StageRunner> runner_;
  Stopwatch watch_;
  std::uint64_t written_ = 0;                     // see WrittenFiles::size
  double last_report_ = 0, last_checkpoint_ = 0;  // (s) of wall time
  std::uint64_t last_checkpoint_step_ = 0;
  bool checkpoint_due_ = false;  // by wall time
  bool checkpoint_failed_ = false;
};

}  // namespace

RunResult run_from(const State* state, const scenario::Plan& plan, const RunOptions& options,
                   RunDirectory& directory) {
  Run run(plan, options, directory, state);
  if (run.finished())
    throw Error(fmt::format("{}: the run has finished at t = {:g} s; give a later --until to prolong it",
                            directory.path().string(), time_of(*state)));
  return run.execute();
}

RunResult run_plan(const scenario::Plan& plan, const RunOptions& options) {
  RunDirectory directory = directory_of(plan, options);
  return run_from(nullptr, plan, options, directory);
}

}  // namespace scree::run
