#include "run.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/files/try_each.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/stage_loop.hpp>
#include <scree/run/step_check.hpp>
#include <scree/run/warnings.hpp>

namespace scree::run {

namespace {

constexpr const char* final_packing = "final_packing.csv";

Progress progress_of(const Simulation& simulation, const StageRunner& runner, double wall_time) {
  const Stage& stage = runner.stages()[runner.current()];
  return {runner.progress(),      wall_time,      simulation.time(), stage.name, runner.current() + 1,
          runner.stages().size(), runner.status()};
}

}  // namespace

// Stages with samples, pictures and checkpoints; the last state; the last picture, the final packing and
// charts; verdicts. A final state that cannot be written fails the run after all else has been saved.
bool Run::work() {
  // Its scenario is that of the state from which the run goes on should it be killed.
  if (prolonged_) states_.write_checkpoint(), states_.finish();
  announce();
  session_.restart_watch();
  const std::string last = run_stages();
  const bool complete = runner_->finished();
  results_.end_stage(complete ? name_of(runner_->last_end()) : "interrupted");
  session_.watch().time_output([&] {
    write_last_state(complete);
    sampler_.sample_last(*simulation_, last);
    fields_.take_last(*simulation_, last);
    fields_.flush();
    write_results(complete);
  });
  if (no_final_state_) std::rethrow_exception(no_final_state_);
  for (const std::string& warning : result_warnings(*simulation_)) session_.warn(warning);
  results_.take_quantities();
  return complete;
}

Run::Run(const scenario::Plan& plan, const RunOptions& options, Session& session,
         std::unique_ptr<Simulation> simulation)
    : plan_(plan),
      options_(options),
      session_(session),
      simulation_(std::move(simulation)),
      sampler_(plan),
      pictures_(plan, session.directory()),
      fields_(plan, session.directory(), options.threads),
      results_(plan, options, session, *simulation_),
      states_(plan.checkpoint, session, *simulation_, results_, [this] { return save_state(); }) {}

void Run::prepare() {
  fields_.prepare(*simulation_);
  start_warnings_ = start_warnings(plan_, *simulation_);
  session_.note(start_warnings_);
  results_.take_quantities();
}

void Run::restore(const State& state) {
  const StateTransfer from = StateTransfer::restoring_from(state).below("run");
  runner_.emplace(*simulation_, plan_.stages, from.below("stages"), unowned(sampler_));
  sampler_.transfer_probes(from.below("probes"));
  sampler_.check_restored(*simulation_);
  pictures_.transfer(from.below("pictures"));
  fields_.prepare(*simulation_);
  fields_.transfer(from.below("fields"));
  results_.transfer(from.below("results"));
  results_.go_on_with_times();
  from.value("written", "1", written_);
  std::string scenario;
  from.value("scenario", "", scenario);
  prolonged_ = scenario != plan_.resolved_text;
  sampler_.reopen(session_.directory().series(), results_.stages());
  results_.take_quantities();
}

void Run::open() {
  const RunDirectory& directory = session_.directory();
  directory.add(final_packing);
  for (const scenario::ProbePlan& probe : plan_.probes) directory.add("series/" + probe.name + ".csv");
  try {
    sampler_.open(directory.series());
  } catch (const std::exception&) {
    sampler_.close();  // too many open files cannot be removed
    throw;
  }
}

// What the run wrote after the state is dropped.
void Run::reopen() {
  session_.directory().written().return_to(written_);
  states_.remove_later();
  sampler_.cut();
  pictures_.cut();
  fields_.cut();
}

void Run::announce() {
  if (options_.on_start) options_.on_start(*simulation_);
  if (options_.on_warning)
    for (const std::string& warning : start_warnings_) options_.on_warning(warning);
}

std::string Run::run_stages() {
  try {
    return drive_stages();
  } catch (const Error& error) {
    not_reached_ = error.status() == ExitStatus::not_reached;
    throw;
  }
}

std::string Run::drive_stages() {
  if (!runner_) return run_with_hooks(runner_.emplace(*simulation_, plan_.stages, unowned(sampler_)), *this);
  if (runner_->finished()) return plan_.stages.back().name;  // killed after its last state
  const std::uint64_t steps = runner_->steps();
  const std::string stage = plan_.stages[runner_->current()].name;
  return run_with_hooks(
      *runner_, *this,
      std::min({sampler_.next(*simulation_, stage, steps), pictures_.next(*simulation_, steps),
                fields_.next(*simulation_, stage, steps), states_.next(steps)}));
}

void Run::write_last_state(bool complete) {
  if (!complete) {
    states_.write_checkpoint();
  } else {
    try {
      states_.write_final();
    } catch (const std::exception&) {
      no_final_state_ = std::current_exception();
    }
  }
  states_.finish();
}

void Run::write_results(bool complete) {
  sampler_.flush();
  pictures_.take_last(*simulation_);
  write_final_packing(*simulation_, session_.directory().add(final_packing));
  const auto warn = [this](const std::string& line) { session_.warn(line); };
  pictures_.draw_charts(sampler_, warn);
  if (!complete) return;
  pictures_.make_film(warn);
  results_.judge(sampler_);
  for (const std::string& warning : sampler_.unfilled()) session_.warn(warning);
}

void Run::end_failed() {
  results_.end_stage("failed");
  results_.take_quantities();
}

// A stage that was not reached goes on from its last step when it is given more time, as if it had had it.
void Run::save_failed() {
  files::try_each([&] { save_unreached(); }, [&] { sampler_.flush(); },
                  [&] { write_final_packing(*simulation_, session_.directory().add(final_packing)); },
                  [&] { pictures_.take_last(*simulation_); }, [&] { fields_.flush(); });
}

void Run::save_unreached() {
  if (!not_reached_) return;
  const std::string& stage = plan_.stages[runner_->current()].name;
  observe(stage, runner_->steps());
  // A run that goes on must be able to end this stage earlier, from a state before.
  if (runner_->next_is_refused()) return states_.write_stage(stage);
  try {
    states_.write_before_failure();
  } catch (const Error& error) {
    session_.warn(fmt::format("the state before the failure is not kept: {}", error.what()));
  }
}

nlohmann::ordered_json Run::record() { return results_.record(); }

State Run::save_state() {
  State state = simulation_->changing_state();
  const StateTransfer to = StateTransfer::saving_to(state).below("run");
  std::string scenario = plan_.resolved_text;
  to.value("scenario", "", scenario);
  runner_->save(to.below("stages"));
  sampler_.flush();
  sampler_.transfer_probes(to.below("probes"));
  pictures_.transfer(to.below("pictures"));
  fields_.flush();
  fields_.transfer(to.below("fields"));
  results_.transfer(to.below("results"));
  written_ = session_.directory().written().size();
  to.value("written", "1", written_);
  return state;
}

void Run::begin(const std::string& stage) {
  if (const std::size_t before = results_.stages(); before > 0) ended_stage_ = plan_.stages[before - 1].name;
  results_.begin_stage(stage, name_of(runner_->last_end()));
  sampler_.begin_stage(results_.stages());
  check_step(plan_, *simulation_);
}

std::uint64_t Run::observe(const std::string& stage, std::uint64_t steps) {
  return session_.watch().time_output([&] {
    return std::min({sampler_.take(*simulation_, stage, steps), pictures_.take(*simulation_, steps),
                     fields_.take(*simulation_, stage, steps), states_.next(steps)});
  });
}

bool Run::proceed(const StageRunner& runner) {
  report_progress(runner);
  return proceeds();
}

bool Run::proceeds() const { return session_.proceeds() && !simulation_->is_interrupted_elsewhere(); }

void Run::between(const StageRunner& runner) {
  if (!ended_stage_.empty())
    session_.watch().time_output([&] { states_.write_stage(std::exchange(ended_stage_, "")); });
  if (!runner.finished() && proceeds()) session_.watch().time_output([&] { states_.write_due(); });
}

void Run::report_progress(const StageRunner& runner) {
  constexpr std::uint64_t steps_between_checks = 32;
  constexpr double seconds_between_reports = 0.2;
  if (simulation_->steps() % steps_between_checks) return;
  const double wall_time = session_.watch().total();
  if (wall_time - last_report_ < seconds_between_reports) return;
  last_report_ = wall_time;
  session_.directory().check_in_place();
  sampler_.flush();
  fields_.flush();
  states_.look_at_clock();
  if (options_.on_progress && !runner.finished())
    options_.on_progress(progress_of(*simulation_, runner, wall_time));
}

SessionOptions session_options_of(const RunOptions& options) {
  return {options.out, options.overwrite, {}, options.on_warning, options.stop};
}

RunResult run_plan(const scenario::Plan& plan, const RunOptions& options) {
  require_stages(plan);
  Session session(run_results, plan, session_options_of(options));
  Run run(plan, options, session, set_up(plan, options.threads, options.ranks));
  session.begin(run);
  return run.result();
}

}  // namespace scree::run
