#pragma once

#include "checkpoints.hpp"
#include "results.hpp"

#include <functional>
#include <future>
#include <string>

#include <scree/run/session.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// Writes the states of a run when they are due by wall time or simulated time, and at its end. A checkpoint
// is written by a thread of its own while the run goes on, one at a time; by this one if there is no other.
class StateWriter {
 public:
  // save: the state of the run at the time of the call, after its file has been listed.
  StateWriter(const scenario::CheckpointPlan& plan, Session& session, const Simulation& simulation,
              Results& results, std::function<State()> save);

  // Compares the wall time with that of the last checkpoint.
  void look_at_clock();
  // Whether a checkpoint is due by wall time.
  bool is_waiting() const { return waiting_; }
  // Step count after the start of a stage at which a checkpoint is due by simulated time; `steps`: the
  // present one.
  std::uint64_t next(std::uint64_t steps) const;
  // Writes a checkpoint if one is due.
  void write_due();
  // Begins to write one, after the last is written. One that cannot be written is reported, once.
  void write_checkpoint();
  // Waits until the last checkpoint is on the disk.
  void finish();
  // Writes the state at the end of a stage and the start of the next one. One that cannot be written is
  // reported.
  void write_stage(const std::string& stage);
  // Throw Error (failure) if it cannot be written.
  void write_final();
  void write_before_failure();
  // Removes checkpoints of later steps than those of a run that goes on.
  void remove_later() { checkpoints_.remove_later(simulation_.steps()); }

 private:
  bool is_due_by_time() const;
  // Takes the state, whose time is counted.
  State take();
  void write(const std::filesystem::path& path);
  void report(const std::string& problem);

  const scenario::CheckpointPlan& plan_;
  Checkpoints checkpoints_;
  const Simulation& simulation_;
  Session& session_;
  Results& results_;
  std::function<State()> save_;
  bool waiting_ = false, failed_ = false, without_thread_ = false;
  Cadence cadence_;
  std::uint64_t last_step_;
  std::future<void> writing_;
};

}  // namespace scree::run
