#include "state_writer.hpp"

#include "sampler.hpp"

#include <new>
#include <utility>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/state_file/state_file.hpp>
#include <scree/threads.hpp>

namespace scree::run {

namespace {

constexpr const char* no_memory =
    "there is no memory for a copy of the state; use fewer bodies, or checkpoint.every = \"never\"";

}  // namespace

StateWriter::StateWriter(const scenario::CheckpointPlan& plan, Session& session, const Simulation& simulation,
                         Results& results, std::function<State()> save)
    : plan_(plan),
      checkpoints_(session.directory()),
      simulation_(simulation),
      session_(session),
      results_(results),
      save_(std::move(save)),
      cadence_(plan),
      last_step_(simulation.steps()) {}

void StateWriter::look_at_clock() { waiting_ |= cadence_.is_due(session_.watch().total()); }

std::uint64_t StateWriter::next(std::uint64_t steps) const {
  if (!plan_.every_time) return never;
  const std::uint64_t now = simulation_.steps(),
                      next = next_due(now, *plan_.every_time, simulation_.step_length());
  return next == never ? never : steps + (next - now);
}

bool StateWriter::is_due_by_time() const {
  const std::uint64_t steps = simulation_.steps();
  return plan_.every_time && steps > last_step_ &&
         is_due(steps, *plan_.every_time, simulation_.step_length());
}

void StateWriter::write_due() {
  if (waiting_ || is_due_by_time()) write_checkpoint();
}

void StateWriter::write_checkpoint() {
  finish();
  waiting_ = false;
  last_step_ = simulation_.steps();
  try {
    const std::filesystem::path path = checkpoints_.add(last_step_);
    bool has_thread = true;
    writing_ = in_background(
        [this, path, state = take()]() mutable {
          simulation_.add_unchanging_state(state);
          state_file::write_state(path, state);
          checkpoints_.remove_old();
        },
        &has_thread);
    if (!has_thread && !std::exchange(without_thread_, true))
      session_.warn(
          "no thread can be started, and the run waits while a checkpoint is written; raise the limit of processes "
          "(ulimit -u), or end others");
    session_.record_running();  // they are in no state
  } catch (const Error& error) {
    report(error.what());
  } catch (const std::bad_alloc&) {
    report(no_memory);
  }
  cadence_.restart(session_.watch().total(), simulation_.time());
}

void StateWriter::finish() {
  if (!writing_.valid()) return;
  try {
    writing_.get();
    failed_ = false;
  } catch (const Error& error) {
    report(error.what());
  } catch (const std::bad_alloc&) {
    report(no_memory);
  }
}

void StateWriter::report(const std::string& problem) {
  // One warning until one succeeds again: on a full disk each would lengthen run.json.
  if (!std::exchange(failed_, true))
    session_.warn(fmt::format("no checkpoint at t = {:g} s: {}",
                              double(last_step_) * simulation_.step_length(), problem));
}

void StateWriter::write_final() {
  finish();
  if (!plan_.final_state) return;
  write(checkpoints_.add_final());
}

void StateWriter::write_before_failure() {
  finish();
  write(checkpoints_.add(simulation_.steps()));
}

void StateWriter::write_stage(const std::string& stage) {
  if (!plan_.stage_states) return;
  try {
    write(checkpoints_.add_stage(stage));
    session_.record_running();  // which lists it
  } catch (const Error& error) {
    session_.warn(fmt::format("no state at the end of stage '{}': {}", stage, error.what()));
  } catch (const std::bad_alloc&) {
    session_.warn(fmt::format("no state at the end of stage '{}': {}", stage, no_memory));
  }
}

void StateWriter::write(const std::filesystem::path& path) {
  State state = take();
  simulation_.add_unchanging_state(state);
  state_file::write_state(path, state);
}

State StateWriter::take() {
  const double start = session_.watch().total();
  State state = save_();
  results_.count_state(session_.watch().total() - start);
  return state;
}

}  // namespace scree::run
