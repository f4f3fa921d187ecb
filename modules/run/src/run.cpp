#include "drive.hpp"
#include "expectations.hpp"
#include "final_packing.hpp"
#include "pictures.hpp"
#include "run_record.hpp"
#include "sampler.hpp"
#include "spare_room.hpp"
#include "stopwatch.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/run/run.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/warnings.hpp>
#include <scree/scenario/quantities.hpp>

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

class Run {
 public:
  Run(const scenario::Plan& plan, const RunOptions& options)
      : plan_(plan),
        options_(options),
        directory_(directory_of(plan, options)),
        simulation_(set_up(plan, options.threads)),
        sampler_(plan),
        pictures_(plan, directory_) {
    result_.directory = directory_.path();
  }

  RunResult execute() {
    prepare();
    if (options_.on_start) options_.on_start(*simulation_);
    for (const std::string& warning : start_warnings(plan_, *simulation_)) warn(warning);
    try {
      loop();
      watch_.time_output([&] {
        save();
        pictures_.draw_charts(sampler_, [this](const std::string& line) { warn(line); });
      });
      judge();
    } catch (const Error& error) {
      fail(error.what());
      // The status bad_input is reserved for errors before anything is written.
      throw error.status() == ExitStatus::bad_input ? Error(error.what(), ExitStatus::failure) : error;
    } catch (const std::exception& error) {
      fail(error.what());
      throw;
    }
    for (const std::string& warning : result_warnings(*simulation_)) warn(warning);
    room_.release();
    record(result_.interrupted ? "interrupted" : "finished", "");
    return result_;
  }

 private:
  // If the first files cannot be written, the directory is removed again.
  void prepare() {
    directory_.create();
    try {
      record("running", "");
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

  void loop() {
    watch_ = {};
    StageRunner runner(*simulation_, plan_.stages);
    const std::string last = drive(
        runner, [this](const std::string& stage) { begin_stage(stage); },
        [this](const std::string& stage, std::uint64_t steps) { return observe(stage, steps); },
        [this](const StageRunner& r) {
          report_progress(r);
          return !(options_.stop && *options_.stop);
        });
    result_.interrupted = !runner.finished();
    end_stage(result_.interrupted ? "interrupted" : "");
    watch_.time_output([&] { sampler_.sample_last(*simulation_, last); });
  }

  void begin_stage(const std::string& name) {
    end_stage("");
    result_.stages.push_back({name, simulation_->time(), simulation_->time(), 0, "running"});
    stage_first_step_ = simulation_->steps();
    sampler_.begin_stage(result_.stages.size());
    check_step(plan_, *simulation_);
  }

  // `how`: empty if the stage has reached its end.
  void end_stage(const std::string& how) {
    if (result_.stages.empty()) return;
    StageResult& stage = result_.stages.back();
    stage.end = simulation_->time();
    stage.steps = simulation_->steps() - stage_first_step_;
    const bool timed = plan_.stages[result_.stages.size() - 1].duration.has_value();
    stage.ended = !how.empty() ? how : timed ? "duration" : "condition";
  }

  // Takes samples and pictures that are due `steps` after the start of a stage. Returns the step count at
  // which the next are due.
  std::uint64_t observe(const std::string& stage, std::uint64_t steps) {
    return watch_.time_output([&] {
      return std::min(sampler_.sample(*simulation_, stage, steps), pictures_.take(*simulation_, steps));
    });
  }

  void report_progress(const StageRunner& runner) {
    constexpr std::uint64_t steps_between_checks = 32;
    constexpr double seconds_between_reports = 0.2;
    if (simulation_->steps() % steps_between_checks) return;
    const double wall = watch_.total();
    if (wall - last_report_ < seconds_between_reports) return;
    last_report_ = wall;
    sampler_.flush();
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

  void warn(const std::string& line) {
    result_.warnings.push_back(line);
    if (options_.on_warning) options_.on_warning(line);
  }

  void save() {
    sampler_.flush();
    pictures_.take_last(*simulation_);
    write_final_packing(*simulation_, directory_.path() / final_packing);
  }

  // Saves what can be saved. Further errors are discarded, so that the user sees the original one.
  void fail(const std::string& reason) {
    end_stage("failed");
    room_.release();
    try_each([&] { record("failed", files::one_line(reason, 2000)); }, [&] { sampler_.flush(); },
             [&] { write_final_packing(*simulation_, directory_.path() / final_packing); },
             [&] { pictures_.take_last(*simulation_); });
  }

  void judge() {
    if (result_.interrupted) return;
    result_.quantities = scenario::run_quantities(*simulation_);
    const auto column = [&](const std::string& probe, const std::string& name) {
      return sampler_.series(probe).column(name);
    };
    for (const scenario::Expectation& e : plan_.expectations)
      result_.verdicts.push_back(judge_expectation(e, result_.quantities, column));
  }

  void record(const std::string& status, const std::string& error) {
    result_.quantities = scenario::run_quantities(*simulation_);
    result_.state_hash = simulation_->state_hash();
    result_.wall = watch_.total();
    result_.output = watch_.output();
    const double work = double(simulation_->steps()) * double(simulation_->particles().size());
    const double stepping = result_.wall - result_.output;
    result_.particle_steps_per_second = stepping > 0 ? work / stepping : 0;
    directory_.write_file("run.json", run_record(plan_, options_, result_, *simulation_, status, error));
  }

  const scenario::Plan& plan_;
  const RunOptions& options_;
  RunDirectory directory_;
  std::unique_ptr<Simulation> simulation_;
  SpareRoom room_;
  Sampler sampler_;
  Pictures pictures_;
  RunResult result_;
  Stopwatch watch_;
  double last_report_ = 0;              // (s) of wall time
  std::uint64_t stage_first_step_ = 0;  // steps before the present stage
};

}  // namespace

RunResult run_plan(const scenario::Plan& plan, const RunOptions& options) {
  return Run(plan, options).execute();
}

}  // namespace scree::run
