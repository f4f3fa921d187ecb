#include "drive.hpp"
#include "expectations.hpp"
#include "final_packing.hpp"
#include "pictures.hpp"
#include "run_record.hpp"
#include "sampler.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/run/run.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/run/set_up.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::run {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

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

class Run {
 public:
  Run(const scenario::Plan& plan, const RunOptions& options)
      : plan_(plan),
        options_(options),
        directory_(options.out, options.overwrite),
        simulation_(set_up(plan, options.threads)),
        sampler_(plan),
        pictures_(plan, *simulation_, directory_) {
    result_.directory = directory_.path();
  }

  RunResult execute() {
    prepare();
    if (options_.on_start) options_.on_start(*simulation_);
    try {
      loop();
      finish_timing();
      save();
    } catch (const Error& error) {
      fail(error.what());
      // The status bad_input is reserved for errors before anything is written.
      throw error.status() == ExitStatus::bad_input ? Error(error.what(), ExitStatus::failure) : error;
    } catch (const std::exception& error) {
      fail(error.what());
      throw;
    }
    pictures_.draw_charts(sampler_, options_.on_message);
    judge();
    record(result_.interrupted ? "interrupted" : "finished", "");
    return result_;
  }

 private:
  // If the first files cannot be written, the directory is removed again.
  void prepare() {
    directory_.create();
    try {
      record("running", "");
      directory_.write_file("scenario.toml", plan_.resolved_text);
      sampler_.open(directory_.series());
    } catch (const std::exception&) {
      directory_.discard();
      throw;
    }
  }

  void loop() {
    started_ = Clock::now();
    StageRunner runner(*simulation_, plan_.stages);
    const std::string last = drive(
        runner, [this](const std::string&) { check_step(plan_, *simulation_); },
        [this](const std::string& stage, std::uint64_t steps) { return observe(stage, steps); },
        [this](const StageRunner& r) {
          report_progress(r);
          return !(options_.stop && *options_.stop);
        });
    result_.interrupted = !runner.finished();
    sampler_.sample_last(*simulation_, last);
  }

  // Takes samples and pictures that are due `steps` after the start of a stage. Returns the step count at
  // which the next are due.
  std::uint64_t observe(const std::string& stage, std::uint64_t steps) {
    return std::min(sampler_.sample(*simulation_, stage, steps), pictures_.take(*simulation_, steps));
  }

  void report_progress(const StageRunner& runner) {
    constexpr std::uint64_t steps_between_checks = 32;
    constexpr double seconds_between_reports = 0.2;
    if (simulation_->steps() % steps_between_checks) return;
    const double wall = seconds_since(started_);
    if (wall - last_report_ < seconds_between_reports) return;
    last_report_ = wall;
    sampler_.flush();
    const std::string stage = runner.finished() ? "" : runner.stages()[runner.current()].name;
    if (options_.on_progress) options_.on_progress({runner.progress(), wall, simulation_->time(), stage});
  }

  void finish_timing() {
    result_.wall = seconds_since(started_);
    const double work = double(simulation_->steps()) * double(simulation_->particles().size());
    result_.particle_steps_per_second = result_.wall > 0 ? work / result_.wall : 0;
  }

  void save() {
    sampler_.flush();
    pictures_.take_last(*simulation_);
    write_final_packing(*simulation_, directory_.path() / "final_packing.csv");
  }

  // Saves what can be saved. Further errors are discarded, so that the user sees the original one.
  void fail(const std::string& reason) {
    finish_timing();
    try_each([&] { record("failed", files::one_line(reason, 2000)); }, [&] { sampler_.flush(); },
             [&] { pictures_.take_last(*simulation_); },
             [&] { write_final_packing(*simulation_, directory_.path() / "final_packing.csv"); });
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
    directory_.write_file("run.json", run_record(plan_, options_, result_, *simulation_, status, error));
  }

  const scenario::Plan& plan_;
  const RunOptions& options_;
  RunDirectory directory_;
  std::unique_ptr<Simulation> simulation_;
  Sampler sampler_;
  Pictures pictures_;
  RunResult result_;
  Clock::time_point started_ = Clock::now();
  double last_report_ = 0;  // (s) of wall time
};

}  // namespace

RunResult run_plan(const scenario::Plan& plan, const RunOptions& options) {
  return Run(plan, options).execute();
}

}  // namespace scree::run
